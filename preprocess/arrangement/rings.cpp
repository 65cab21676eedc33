// rings: concentric rings about the centre of a disc or ring, 2π r/δ particles on each, by `rounding` ("nearest" or
// "down"). `radii` says where they lie: "edges-included" from the centre particle (or the inner edge) to the outer
// edge, "cell-centred" half a spacing inside both. The radial distance is stretched to the nearest whole number of
// intervals.

#include <array>

#include "preprocess/arrangement/arrangements.hpp"
#include "preprocess/arrangement/ring_points.hpp"

namespace tektite::preprocess {
namespace {

class Rings final : public Arrangement {
 public:
  Rings(Rounding rounding, bool edges_included, double start_angle)
      : rounding_(rounding), edges_included_(edges_included), start_angle_(start_angle) {}

  Filling fill(const Shape& shape, double spacing, const Share& share) const override {
    const auto round = expect_round(shape, "rings", "disc, ring");
    Filling filling;
    const auto rings = radii(round, spacing, edges_included_);
    std::vector<std::size_t> counts;
    for (const double radius : rings) counts.push_back(ring_count(radius / spacing, rounding_));
    for_share(share, counts, [&](std::size_t ring, std::size_t from, std::size_t to) {
      append_ring(filling.positions, {round.centre, rings[ring], counts[ring], start_angle_}, from, to);
    });
    filling.cell = spacing * spacing;
    return filling;
  }

 private:
  Rounding rounding_;
  bool edges_included_;
  double start_angle_;
};

}  // namespace

ArrangementPointer read_rings(Section& section, int) {
  const auto rounding = read_rounding(section, "rounding", "nearest");
  const std::array<std::string, 2> places{"edges-included", "cell-centred"};
  const bool edges_included = section.choice("radii", places, "edges-included") == "edges-included";
  return std::make_unique<Rings>(rounding, edges_included, read_start_angle(section));
}

}  // namespace tektite::preprocess
