// lattice-with-rings: a square lattice with a particle on the centre of a disc, within r < (R/δ − rings) δ strictly,
// and `rings` rings around it at r = R, R − δ, ... The outermost has 2π R/δ particles by `rounding`, the others by
// `inner_rounding`: "nearest" and "down" give the published 7830 of a disc of 50 spacings with two rings.

#include <cmath>

#include "preprocess/arrangement/arrangements.hpp"
#include "preprocess/arrangement/ring_points.hpp"

namespace tektite::preprocess {
namespace {

class LatticeWithRings final : public Arrangement {
 public:
  LatticeWithRings(int rings, Rounding outer, Rounding inner, double start_angle)
      : rings_(rings), outer_(outer), inner_(inner), start_angle_(start_angle) {}

  Filling fill(const Shape& shape, double spacing) const override {
    const auto round = expect_round(shape, "lattice-with-rings", "disc");
    if (round.inner > 0.0) throw InputError("the arrangement lattice-with-rings suits a disc without a hole alone");
    const double core = round.outer / spacing - rings_;  // in spacings
    Filling filling;
    filling.cell = spacing * spacing;
    append_lattice(filling.positions, round.centre, core, spacing);
    for (int k = rings_ - 1; k >= 0; --k) {
      const double radius = round.outer / spacing - k;
      if (radius < edge_tolerance) continue;
      append_ring(filling.positions, round.centre, radius * spacing, ring_count(radius, k == 0 ? outer_ : inner_),
                  start_angle_);
    }
    return filling;
  }

 private:
  static void append_lattice(std::vector<Point>& positions, const Point& centre, double core, double spacing) {
    const auto most = floor_within(std::max(core, 0.0));
    for (auto j = -most; j <= most; ++j)
      for (auto i = -most; i <= most; ++i) {
        const auto x = static_cast<double>(i), y = static_cast<double>(j);
        if (std::hypot(x, y) < core - edge_tolerance)
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
