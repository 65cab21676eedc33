// How smooth pressure is where total-Lagrangian and Eulerian particles meet: the largest difference between two
// neighbours of different kernel type, against the largest between two neighbours of the same type there. A field that
// does not notice the interface gives about 1, however steep it is.

#include <algorithm>
#include <cmath>

#include "core/error.hpp"
#include "postprocess/measure/measure.hpp"
#include "postprocess/measure/point_grid.hpp"

namespace tektite {
namespace {

/// What the measure looks at: one entry a particle of `whole`.
struct Sides {
  const Whole& whole;
  std::int32_t body;
  std::vector<double> pressure;
  std::vector<std::int64_t> type;
};

/// Calls visit(i, j) for each pair of the body's particles that are nearer than `reach` mean smoothing lengths.
template <class Visit>
void each_pair(const Sides& sides, double reach, const Visit& visit) {
  const auto& whole = sides.whole;
  const auto& h = whole.smoothing_length;
  const PointGrid grid(whole.position, reach * *std::max_element(h.begin(), h.end()));
  grid.for_each_pair(whole.dimensions, [&](std::uint32_t i, std::uint32_t j) {
    if (whole.body[i] != sides.body || whole.body[j] != sides.body) return;
    if (norm(whole.position[i] - whole.position[j]) < 0.5 * reach * (h[i] + h[j])) visit(i, j);
  });
}

/// Particles that have one of the other type within the support of the kernel.
std::vector<bool> interface_zone(const Sides& sides) {
  std::vector<bool> zone(sides.whole.count(), false);
  each_pair(sides, link_of_support, [&](std::uint32_t i, std::uint32_t j) {
    if (sides.type[i] != sides.type[j]) zone[i] = zone[j] = true;
  });
  return zone;
}

/// The ratio of the largest differences among neighbours within `reach` smoothing lengths in the zone.
double jump_ratio(const Sides& sides, const std::vector<bool>& zone, double reach) {
  double across = 0.0;
  double along = 0.0;
  each_pair(sides, reach, [&](std::uint32_t i, std::uint32_t j) {
    if (!zone[i] || !zone[j]) return;
    auto& largest = sides.type[i] == sides.type[j] ? along : across;
    largest = std::max(largest, std::abs(sides.pressure[i] - sides.pressure[j]));
  });
  if (along == 0.0) throw RunError("the pressure is uniform on either side of the interface: nothing to compare with");
  return across / along;
}

Sides sides_of(const Event& event, const std::string& name) {
  const auto& particles = event.last_snapshot.particles;
  require_field(particles, Field::kernel_type);
  require_field(particles, Field::pressure);
  Sides sides{event.last, event.last.body_named(name), {}, {}};
  for (const auto source : event.last.source) {
    sides.pressure.push_back(particles.reals(Field::pressure)[source]);
    sides.type.push_back(particles.integers(Field::kernel_type)[source]);
  }
  return sides;
}

}  // namespace

/// Neighbours are particles within one smoothing length; how far the ratio moves if all within the support are taken is
/// the uncertainty. Keys: body.
Measure read_interface_jump(Section& section, const Declared& declared) {
  const auto name = read_body(section, "body", declared);
  const auto take = [=](const Event& event) {
    const auto sides = sides_of(event, name);
    const auto zone = interface_zone(sides);
    if (std::find(zone.begin(), zone.end(), true) == zone.end())
      throw RunError(name + " has no interface between kernel types");
    const double near = jump_ratio(sides, zone, link_of_smoothing_length);
    const double far = jump_ratio(sides, zone, link_of_support);
    return Measured{near, event.last.time, std::abs(near - far), {}};
  };
  return {take, {Field::kernel_type, Field::pressure}};
}

}  // namespace tektite
