// lattice: a rectangular lattice along the axes, by `convention`:
//   cell-centred    cells fill the bounding box from its lower corner, particles sit in their middles
//   on-origin       a particle sits on `origin`
//   half-off-origin particles sit half a spacing off `origin` in every coordinate
//   edges-included  particles sit on both edges of the bounding box: along each axis the spacing is stretched to the
//                   nearest whole number of intervals
// `origin` is the shape's centre where it is left out.

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>

#include "preprocess/arrangement/arrangements.hpp"
#include "preprocess/arrangement/rows.hpp"

namespace tektite::preprocess {
namespace {

enum class Convention { cell_centred, on_origin, half_off_origin, edges_included };

struct Axis {
  double first = 0.0;
  double step = 1.0;
  long long count = 1;
};

class Lattice final : public Arrangement {
 public:
  Lattice(Convention convention, std::optional<Point> origin) : convention_(convention), origin_(origin) {}

  Filling fill(const Shape& shape, double spacing, const Share& share) const override {
    const auto axes = lay_out(shape, spacing);
    Filling filling;
    filling.positions = fill_rows(shape, rows(axes), edge_tolerance * spacing, share);
    filling.cell = 1.0;
    for (int k = 0; k < shape.dimensions(); ++k) filling.cell *= axes[k].step;
    filling.step_along_x = axes[0].step;
    return filling;
  }

  std::size_t count(const Shape& shape, double spacing) const override {
    return count_rows(shape, rows(lay_out(shape, spacing)), edge_tolerance * spacing);
  }

 private:
  std::array<Axis, 3> lay_out(const Shape& shape, double spacing) const {
    std::array<Axis, 3> axes;
    const auto box = shape.bounds();
    const auto origin = origin_.value_or(shape.centre());
    for (int k = 0; k < shape.dimensions(); ++k) axes[k] = along(box.lower[k], box.upper[k], origin[k], spacing);
    return axes;
  }

  Axis along(double lower, double upper, double origin, double spacing) const {
    const double extent = upper - lower;
    if (convention_ == Convention::cell_centred)
      return {lower + 0.5 * spacing, spacing, floor_within(extent / spacing - 0.5) + 1};
    if (convention_ == Convention::edges_included) {
      const auto intervals = std::max(nearest_whole(extent / spacing), 1LL);
      return {lower, extent / static_cast<double>(intervals), intervals + 1};
    }
    const double start = convention_ == Convention::on_origin ? origin : origin + 0.5 * spacing;
    const auto first = ceil_within((lower - start) / spacing);
    const auto last = floor_within((upper - start) / spacing);
    return {start + static_cast<double>(first) * spacing, spacing, std::max(last - first + 1, 0LL)};
  }

  /// Rows along x; y runs before z.
  static Rows rows(const std::array<Axis, 3>& axes) {
    const auto& [x, y, z] = axes;
    if (x.count <= 0 || y.count <= 0 || z.count <= 0) return {0, {}};
    return {static_cast<std::size_t>(y.count * z.count), [x = x, y = y, z = z](std::size_t k) {
              const auto j = static_cast<long long>(k) % y.count, l = static_cast<long long>(k) / y.count;
              return Row{
                  {{x.first, y.first + static_cast<double>(j) * y.step, z.first + static_cast<double>(l) * z.step}},
                  {{x.step, 0.0, 0.0}},
                  static_cast<std::size_t>(x.count)};
            }};
  }

  Convention convention_;
  std::optional<Point> origin_;
};

}  // namespace

ArrangementPointer read_lattice(Section& section, int dimensions) {
  const std::array<std::string, 4> names{"cell-centred", "on-origin", "half-off-origin", "edges-included"};
  const auto name = section.choice("convention", names, "cell-centred");
  auto convention = Convention::cell_centred;
  if (name == "on-origin") convention = Convention::on_origin;
  if (name == "half-off-origin") convention = Convention::half_off_origin;
  if (name == "edges-included") convention = Convention::edges_included;
  std::optional<Point> origin;
  const bool has_origin = convention == Convention::on_origin || convention == Convention::half_off_origin;
  if (has_origin && section.has("origin")) origin = read_point(section, "origin", dimensions);
  return std::make_unique<Lattice>(convention, origin);
}

}  // namespace tektite::preprocess
