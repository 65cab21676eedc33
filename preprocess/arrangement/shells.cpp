// shells: concentric shells about the centre of a sphere, each with the integer nearest to 4π r²/δ² particles on a
// Fibonacci spiral: point k lies at height z = 1 − (2k + 1)/n and turns by the golden angle from the one before, which
// spreads points of nearly equal area without a preferred axis. `radii` as for rings.

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include "preprocess/arrangement/arrangements.hpp"
#include "preprocess/arrangement/ring_points.hpp"

namespace tektite::preprocess {
namespace {

using std::numbers::pi;

std::size_t shell_count(double radius_in_spacings) {
  return static_cast<std::size_t>(std::max(nearest_whole(4.0 * pi * radius_in_spacings * radius_in_spacings), 1LL));
}

void append_shell(std::vector<Point>& positions, const Point& centre, double radius, std::size_t count) {
  const double golden_angle = pi * (3.0 - std::sqrt(5.0));
  for (std::size_t k = 0; k < count; ++k) {
    const double z = 1.0 - static_cast<double>(2 * k + 1) / static_cast<double>(count);
    const double r = std::sqrt((1.0 - z) * (1.0 + z)), angle = golden_angle * static_cast<double>(k);
    positions.push_back(centre + radius * Point{{r * std::cos(angle), r * std::sin(angle), z}});
  }
}

class Shells final : public Arrangement {
 public:
  explicit Shells(bool edges_included) : edges_included_(edges_included) {}

  Filling fill(const Shape& shape, double spacing) const override {
    const auto round = expect_round(shape, "shells", "sphere");
    Filling filling;
    for (const double radius : radii(round, spacing, edges_included_))
      append_shell(filling.positions, round.centre, radius, shell_count(radius / spacing));
    filling.cell = spacing * spacing * spacing;
    return filling;
  }

 private:
  bool edges_included_;
};

}  // namespace

ArrangementPointer read_shells(Section& section, int) {
  const std::array<std::string, 2> places{"edges-included", "cell-centred"};
  return std::make_unique<Shells>(section.choice("radii", places, "edges-included") == "edges-included");
}

}  // namespace tektite::preprocess
