#include "postprocess/whole.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <functional>
#include <utility>

#include "core/error.hpp"
#include "core/kernel_type.hpp"

namespace tektite {
namespace {

/// Gives particles that have a field where there are any, until the next call.
using ParticlesWith = std::function<const Particles&(Field)>;

std::vector<Point> points_of(const Particles& particles, Field field) {
  const auto width = static_cast<std::size_t>(particles.dimensions());
  const auto values = particles.reals(field);
  std::vector<Point> points(particles.count(), Point::zero());
  for (std::size_t i = 0; i < points.size(); ++i)
    for (std::size_t k = 0; k < width; ++k) points[i][static_cast<int>(k)] = values[i * width + k];
  return points;
}

std::vector<double> scalars_of(const Particles& particles, Field field) {
  const auto values = particles.reals(field).first(particles.count());
  return {values.begin(), values.end()};
}

template <class T>
void repeat(std::vector<T>& column) {
  const auto count = column.size();
  column.reserve(2 * count);
  for (std::size_t i = 0; i < count; ++i) column.push_back(column[i]);
}

void add_images(Whole& whole, const SymmetryPlane& plane, int bit) {
  const auto count = whole.count();
  repeat(whole.position);
  repeat(whole.velocity);
  repeat(whole.mass);
  repeat(whole.smoothing_length);
  repeat(whole.body);
  repeat(whole.id);
  repeat(whole.source);
  repeat(whole.image);
  repeat(whole.severed);
  for (std::size_t i = count; i < 2 * count; ++i) {
    whole.position[i][plane.axis] = 2.0 * plane.at - whole.position[i][plane.axis];
    whole.velocity[i][plane.axis] = -whole.velocity[i][plane.axis];
    whole.image[i] = static_cast<std::uint8_t>(whole.image[i] | 1u << bit);
  }
}

/// A total-Lagrangian particle whose damage has reached 1 is taken out of its neighbours' lists. An Eulerian one stays
/// in them, and so does one of a snapshot that does not tell kernel types.
std::vector<std::uint8_t> severed(const ParticlesWith& with, std::size_t count) {
  std::vector<std::uint8_t> chosen(count, 0);
  const auto& damaged = with(Field::damage);
  if (!damaged.has(Field::damage)) return chosen;
  for (std::size_t i = 0; i < count; ++i) chosen[i] = damaged.reals(Field::damage)[i] >= 1.0 ? 1 : 0;
  const auto& typed = with(Field::kernel_type);
  if (!typed.has(Field::kernel_type)) return std::vector<std::uint8_t>(count, 0);
  const auto total_lagrangian = static_cast<std::int64_t>(KernelType::total_lagrangian);
  for (std::size_t i = 0; i < count; ++i)
    if (typed.integers(Field::kernel_type)[i] != total_lagrangian) chosen[i] = 0;
  return chosen;
}

std::uint64_t key_of(const Whole& whole, std::size_t i) {
  return static_cast<std::uint64_t>(whole.id[i]) << 3 | whole.image[i];
}

/// `beside` tells all but the particles' fields.
Whole whole_of(const Snapshot& beside, const std::vector<SymmetryPlane>& planes, const ParticlesWith& with) {
  const auto& particles = beside.particles;
  const auto count = particles.count();
  Whole whole;
  whole.dimensions = particles.dimensions();
  whole.time = beside.time();
  whole.bodies = particles.bodies();
  whole.position = points_of(with(Field::position), Field::position);
  whole.velocity = points_of(with(Field::velocity), Field::velocity);
  whole.mass = scalars_of(with(Field::mass), Field::mass);
  whole.smoothing_length = scalars_of(with(Field::smoothing_length), Field::smoothing_length);
  const auto id = with(Field::id).integers(Field::id).first(count);
  whole.id.assign(id.begin(), id.end());
  whole.body.resize(count);
  for (std::size_t k = 0; k < whole.bodies.size(); ++k)
    for (auto i = whole.bodies[k].range.begin; i < whole.bodies[k].range.end; ++i)
      whole.body[i] = static_cast<std::int32_t>(k);
  whole.source.resize(count);
  for (std::size_t i = 0; i < count; ++i) whole.source[i] = static_cast<std::uint32_t>(i);
  whole.image.assign(count, 0);
  whole.severed = severed(with, count);
  for (std::size_t k = 0; k < planes.size(); ++k) {
    add_images(whole, planes[k], static_cast<int>(k));
    if (hoops_of(particles.space()) > 0 && planes[k].axis == 0) whole.axis_image = static_cast<std::uint8_t>(1u << k);
  }
  return whole;
}

}  // namespace

std::int32_t Whole::body_named(const std::string& name) const {
  std::vector<std::string> known;
  for (std::size_t k = 0; k < bodies.size(); ++k) {
    if (bodies[k].name == name) return static_cast<std::int32_t>(k);
    known.push_back(bodies[k].name);
  }
  throw RunError(fmt::format("the particle files have no body {}; they have {}", name, join(known)));
}

Whole make_whole(const Snapshot& snapshot, const std::vector<SymmetryPlane>& planes) {
  return whole_of(snapshot, planes, [&](Field) -> const Particles& { return snapshot.particles; });
}

const FieldSet& fields_of_whole() {
  static const FieldSet fields{Field::position, Field::velocity, Field::mass,       Field::smoothing_length,
                               Field::id,       Field::damage,   Field::kernel_type};
  return fields;
}

Whole read_whole(const std::string& path, const std::vector<SymmetryPlane>& planes) {
  Particles read;
  return whole_of(read_fields(path, {}), planes, [&](Field field) -> const Particles& {
    read = {};
    return read = read_fields(path, {field}).particles;
  });
}

std::vector<std::uint32_t> places_in(const Whole& initial, const Whole& now) {
  std::vector<std::pair<std::uint64_t, std::uint32_t>> known(initial.count());  // a hash table is thrice as large
  for (std::size_t i = 0; i < known.size(); ++i) known[i] = {key_of(initial, i), static_cast<std::uint32_t>(i)};
  std::ranges::sort(known);
  std::vector<std::uint32_t> places(now.count());
  for (std::size_t i = 0; i < places.size(); ++i) {
    const auto key = key_of(now, i);
    const auto found = std::ranges::lower_bound(known, key, {}, [](const auto& entry) { return entry.first; });
    if (found == known.end() || found->first != key)
      throw RunError(fmt::format("particle {} of the last snapshot is not in the first one", now.id[i]));
    places[i] = found->second;
  }
  return places;
}

}  // namespace tektite
