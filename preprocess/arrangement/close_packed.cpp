// close-packed: hexagonal layers δ √(2/3) apart, each shifted into the hollows of the one below, so that each particle
// has twelve neighbours at δ. `stacking` "fcc" repeats after three layers, "hcp" after two. A particle sits on
// `origin`, the shape's centre where it is left out. Its cell has the volume δ³/√2.

#include <array>
#include <cmath>

#include "preprocess/arrangement/packed_rows.hpp"

namespace tektite::preprocess {
namespace {

const double row_distance = std::sqrt(3.0) / 2.0;
const double layer_distance = std::sqrt(2.0 / 3.0);
const double hollow = std::sqrt(3.0) / 6.0;  // in y, from a particle to the hollow half a spacing ahead in x

class ClosePacked final : public Arrangement {
 public:
  ClosePacked(int period, std::optional<Point> origin) : period_(period), origin_(origin) {}

  Filling fill(const Shape& shape, double spacing, const Share& share) const override {
    return {fill_rows(shape, rows(shape, spacing), edge_tolerance * spacing, share),
            cell_factor() * spacing * spacing * spacing};
  }
  std::size_t count(const Shape& shape, double spacing) const override {
    return count_rows(shape, rows(shape, spacing), edge_tolerance * spacing);
  }
  double cell_factor() const override { return 1.0 / std::sqrt(2.0); }

 private:
  /// Every layer has the same number of rows, one more than fit at most; the shape decides which places are kept.
  Rows rows(const Shape& shape, double spacing) const {
    const auto box = shape.bounds();
    const auto origin = origin_.value_or(shape.centre());
    const Count z(box, 2, origin, layer_distance * spacing);
    const Count y(box, 1, origin, row_distance * spacing);
    const auto rows_in_layer = y.size + 1;
    return {z.size * rows_in_layer, [=, period = period_](std::size_t k) {
              const auto layer = z.first + static_cast<long long>(k / rows_in_layer);
              const auto j = y.first - 1 + static_cast<long long>(k % rows_in_layer);
              const auto turn = static_cast<double>(((layer % period) + period) % period);
              const double x = turn * 0.5 + (j % 2 == 0 ? 0.0 : 0.5);
              const double height = turn * hollow + static_cast<double>(j) * row_distance;
              return row_through(box,
                                 {{origin[0] + x * spacing, origin[1] + height * spacing,
                                   origin[2] + static_cast<double>(layer) * layer_distance * spacing}},
                                 spacing);
            }};
  }

  int period_;
  std::optional<Point> origin_;
};

}  // namespace

ArrangementPointer read_close_packed(Section& section, int dimensions) {
  const std::array<std::string, 2> stackings{"fcc", "hcp"};
  const int period = section.choice("stacking", stackings, "fcc") == "fcc" ? 3 : 2;
  std::optional<Point> origin;
  if (section.has("origin")) origin = read_point(section, "origin", dimensions);
  return std::make_unique<ClosePacked>(period, origin);
}

}  // namespace tektite::preprocess
