#include "preprocess/arrangement/ring_points.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include "preprocess/arrangement/arrangement.hpp"

namespace tektite::preprocess {

Rounding read_rounding(Section& section, const std::string& key, const std::string& otherwise) {
  const std::array<std::string, 2> names{"nearest", "down"};
  return section.choice(key, names, otherwise) == "down" ? Rounding::down : Rounding::nearest;
}

std::size_t ring_count(double radius_in_spacings, Rounding rounding) {
  const double spacings = 2.0 * std::numbers::pi * radius_in_spacings;
  const auto count = rounding == Rounding::nearest ? nearest_whole(spacings) : floor_within(spacings);
  return static_cast<std::size_t>(std::max(count, 1LL));
}

double read_start_angle(Section& section) {
  constexpr double turn = 2.0 * std::numbers::pi;
  return section.quantity("start_angle", dimension::none, {-turn, turn}, 0.0);
}

void append_ring(std::vector<Point>& positions, const RingOfPoints& ring, std::size_t from, std::size_t to) {
  const auto& centre = ring.centre;
  const double radius = ring.radius, start_angle = ring.start_angle;
  const auto count = ring.count;
  for (std::size_t k = from; k < to; ++k) {
    const double angle = start_angle + 2.0 * std::numbers::pi * static_cast<double>(k) / static_cast<double>(count);
    positions.push_back({centre[0] + radius * std::cos(angle), centre[1] + radius * std::sin(angle), 0.0});
  }
}

Round expect_round(const Shape& shape, const char* arrangement, const char* allowed) {
  const auto round = shape.round();
  if (!round)
    throw InputError(fmt::format("the arrangement {} suits round shapes alone; allowed: {}", arrangement, allowed));
  return *round;
}

std::vector<double> radii(const Round& round, double spacing, bool edges_included) {
  const double thickness = round.outer - round.inner;
  const auto intervals = std::max(nearest_whole(thickness / spacing), 1LL);
  const double step = thickness / static_cast<double>(intervals);
  std::vector<double> result;
  for (long long k = 0; k < intervals + (edges_included ? 1 : 0); ++k)
    result.push_back(round.inner + (static_cast<double>(k) + (edges_included ? 0.0 : 0.5)) * step);
  return result;
}

}  // namespace tektite::preprocess
