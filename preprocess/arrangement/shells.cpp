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

/// Of a shell of `count` particles those from ≤ k < to.
void append_shell(std::vector<Point>& positions, const Point& centre, double radius, std::size_t count,
                  std::size_t from, std::size_t to) {
  const double golden_angle = pi * (3.0 - std::sqrt(5.0));
  for (std::size_t k = from; k < to; ++k) {
    const double z = 1.0 - static_cast<double>(2 * k + 1) / static_cast<double>(count);
    const double r = std::sqrt((1.0 - z) * (1.0 + z)), angle = golden_angle * static_cast<double>(k);
    positions.push_back(centre + radius * Point{{r * std::cos(angle), r * std::sin(angle), z}});
  }
}

class Shells final : public Arrangement {
 public:
  explicit Shells(bool edges_included) : edges_included_(edges_included) {}

  Filling fill(const Shape& shape, double spacing, const Share& share) const override {
    const auto round = expect_round(shape, "shells", "sphere");
    Filling filling;
    const auto shells = radii(round, spacing, edges_included_);
    std::vector<std::size_t> counts;
    for (const double radius : shells) counts.push_back(shell_count(radius / spacing));
    for_share(share, counts, [&](std::size_t shell, std::size_t from, std::size_t to) {
      append_shell(filling.positions, round.centre, shells[shell], counts[shell], from, to);
    });
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
