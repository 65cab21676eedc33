// How near particles of a body come to each other. In a lattice under tension that turns unstable they clump: the
// distance to the nearest neighbour falls under half the spacing.

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "core/error.hpp"
#include "postprocess/measure/measure.hpp"
#include "postprocess/measure/point_grid.hpp"

namespace tektite {
namespace {

/// Distance from each particle of a body to its nearest neighbour in it, in spacings; particles without a neighbour
/// within the support of the kernel have the support's radius. Other bodies' particles have infinity. A particle on a
/// symmetry plane or the axis lies where its own image does, which is no neighbour of it.
std::vector<double> nearest_distances(const Whole& whole, std::int32_t body) {
  const double spacing = whole.bodies[static_cast<std::size_t>(body)].spacing;
  const double same_place = 1e-6 * spacing;
  const auto& h = whole.smoothing_length;
  const double support = link_of_support * *std::max_element(h.begin(), h.end());
  const PointGrid grid(whole.position, support);
  std::vector<double> nearest(whole.count(), limits::infinite);
  for (std::uint32_t i = 0; i < whole.count(); ++i) {
    if (whole.body[i] != body) continue;
    double least = support;
    grid.around(whole.position[i], whole.dimensions, [&](std::uint32_t j) {
      if (j == i || whole.body[j] != body) return;
      const double apart = norm(whole.position[i] - whole.position[j]);
      if (whole.source[j] == whole.source[i] && apart < same_place) return;
      least = std::min(least, apart);
    });
    nearest[i] = least / spacing;
  }
  return nearest;
}

/// Distances, in spacings, that differ by less are one: both particles of a pair have the same, and which of them has
/// the lower id depends on how the scene stands in its axes.
constexpr double tie = 1e-6;

/// Mean nearest distance of the particles of i's body within a smoothing length of i.
double mean_about(const Whole& whole, const PointGrid& grid, const std::vector<double>& nearest, std::uint32_t i) {
  double sum = 0.0, count = 0.0;
  grid.around(whole.position[i], whole.dimensions, [&](std::uint32_t j) {
    if (std::isinf(nearest[j]) || norm(whole.position[j] - whole.position[i]) > whole.smoothing_length[i]) return;
    sum += nearest[j];
    count += 1.0;
  });
  return sum / count;
}

}  // namespace

/// Smallest distance between two particles of the body in the last snapshot, in spacings. As with other extremes, a
/// single pair stands for its surroundings: the uncertainty is the difference to the mean nearest distance of the
/// body's particles within one smoothing length, the largest of those that have the smallest. Keys: body.
Measure read_min_neighbour_distance(Section& section, const Declared& declared) {
  const auto name = read_body(section, "body", declared);
  return [=](const Event& event) {
    const auto& whole = event.last;
    const auto nearest = nearest_distances(whole, whole.body_named(name));
    const double least = *std::min_element(nearest.begin(), nearest.end());
    const auto& h = whole.smoothing_length;
    const PointGrid grid(whole.position, *std::max_element(h.begin(), h.end()));
    double uncertainty = 0.0;
    for (std::uint32_t i = 0; i < whole.count(); ++i)
      if (nearest[i] <= least + tie) uncertainty = std::max(uncertainty, mean_about(whole, grid, nearest, i) - least);
    return Measured{least, whole.time, uncertainty, {}};
  };
}

/// Time of the first snapshot in which two particles of the body are nearer than `ratio` spacings (0.5). It was so at
/// some time after the snapshot before, so the time between the two is the uncertainty. Keys: body, ratio.
Measure read_clumping_time(Section& section, const Declared& declared) {
  const auto name = read_body(section, "body", declared);
  const double ratio = section.quantity("ratio", dimension::none, {0.0, 1.0, true, false}, 0.5);
  return [=](const Event& event) {
    double before = event.initial.time;
    for (const auto& path : event.snapshots) {
      const auto whole = read_whole(path, event.symmetry);
      const auto nearest = nearest_distances(whole, whole.body_named(name));
      if (*std::min_element(nearest.begin(), nearest.end()) < ratio)
        return Measured{whole.time, whole.time, whole.time - before, {}};
      before = whole.time;
    }
    throw RunError(fmt::format("no two particles of {} come nearer than {} spacings in any snapshot", name, ratio));
  };
}

}  // namespace tektite
