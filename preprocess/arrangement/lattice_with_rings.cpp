// lattice-with-rings: a square lattice with a particle on the centre of a disc, within r < (R/δ − rings) δ strictly,
// and `rings` rings around it at r = R, R − δ, ... The outermost has 2π R/δ particles by `rounding`, the others by
// `inner_rounding`: "nearest" and "down" give the published 7830 of a disc of 50 spacings with two rings.

#include <algorithm>
#include <cmath>

#include "preprocess/arrangement/arrangements.hpp"
#include "preprocess/arrangement/ring_points.hpp"

namespace tektite::preprocess {
namespace {

class LatticeWithRings final : public Arrangement {
 public:
  LatticeWithRings(int rings, Rounding outer, Rounding inner, double start_angle)
      : rings_(rings), outer_(outer), inner_(inner), start_angle_(start_angle) {}

  Filling fill(const Shape& shape, double spacing, const Share& share) const override {
    const auto round = expect_round(shape, "lattice-with-rings", "disc");
    if (round.inner > 0.0) throw InputError("the arrangement lattice-with-rings suits a disc without a hole alone");
    // First the rows of the core, then the rings.
    const double core = round.outer / spacing - rings_;  // in spacings
    const auto most = floor_within(std::max(core, 0.0));
    std::vector<std::size_t> counts;
    for (auto j = -most; j <= most; ++j) counts.push_back(row_count(j, core));
    const auto rows = counts.size();
    std::vector<double> radii;
    for (int k = rings_ - 1; k >= 0; --k) {
      const double radius = round.outer / spacing - k;
      if (radius < edge_tolerance) continue;
      radii.push_back(radius);
      counts.push_back(ring_count(radius, k == 0 ? outer_ : inner_));
    }
    Filling filling;
    filling.cell = spacing * spacing;
    auto& positions = filling.positions;
    for_share(share, counts, [&](std::size_t group, std::size_t from, std::size_t to) {
      if (group < rows)
        append_row(positions, round.centre, static_cast<long long>(group) - most, counts[group], spacing, from, to);
      else
        append_ring(positions, {round.centre, radii[group - rows] * spacing, counts[group], start_angle_}, from, to);
    });
    return filling;
  }

 private:
  static bool in_core(long long i, long long j, double core) {
    return std::hypot(static_cast<double>(i), static_cast<double>(j)) < core - edge_tolerance;
  }

  /// How many places the row j of the core has: as many on both sides of its middle.
  static std::size_t row_count(long long j, double core) {
    if (!in_core(0, j, core)) return 0;
    const auto y = static_cast<double>(j);
    auto last = static_cast<long long>(std::sqrt(std::max(core * core - y * y, 0.0)));
    while (!in_core(last, j, core)) --last;
    while (in_core(last + 1, j, core)) ++last;
    return static_cast<std::size_t>(2 * last + 1);
  }

  static void append_row(std::vector<Point>& positions, const Point& centre, long long j, std::size_t count,
                         double spacing, std::size_t from, std::size_t to) {
    const auto first = -static_cast<long long>(count / 2);
    for (auto k = from; k < to; ++k) {
      const auto x = static_cast<double>(first + static_cast<long long>(k)), y = static_cast<double>(j);
      positions.push_back({centre[0] + x * spacing, centre[1] + y * spacing, 0.0});
    }
  }

  int rings_;
  Rounding outer_, inner_;
  double start_angle_;
};

}  // namespace

ArrangementPointer read_lattice_with_rings(Section& section, int) {
  const auto rings = static_cast<int>(section.integer("rings", {1, 1000}, 2));
  const auto outer = read_rounding(section, "rounding", "nearest");
  const auto inner = read_rounding(section, "inner_rounding", "down");
  return std::make_unique<LatticeWithRings>(rings, outer, inner, read_start_angle(section));
}

}  // namespace tektite::preprocess
