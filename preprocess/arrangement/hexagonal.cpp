// hexagonal: rows δ √3/2 apart, every other one shifted by δ/2, so that each particle has six neighbours at δ. A
// particle sits on `origin`, the shape's centre where it is left out. Its cell has the area δ² √3/2.

#include <cmath>

#include "preprocess/arrangement/packed_rows.hpp"

namespace tektite::preprocess {
namespace {

const double row_distance = std::sqrt(3.0) / 2.0;

class Hexagonal final : public Arrangement {
 public:
  explicit Hexagonal(std::optional<Point> origin) : origin_(origin) {}

  Filling fill(const Shape& shape, double spacing, const Share& share) const override {
    return {fill_rows(shape, rows(shape, spacing), edge_tolerance * spacing, share), cell_factor() * spacing * spacing};
  }
  std::size_t count(const Shape& shape, double spacing) const override {
    return count_rows(shape, rows(shape, spacing), edge_tolerance * spacing);
  }
  double cell_factor() const override { return row_distance; }

 private:
  Rows rows(const Shape& shape, double spacing) const {
    const auto box = shape.bounds();
    const auto origin = origin_.value_or(shape.centre());
    const Count y(box, 1, origin, row_distance * spacing);
    return {y.size, [=](std::size_t k) {
              const auto j = y.first + static_cast<long long>(k);
              const double shift = j % 2 == 0 ? 0.0 : 0.5;
              return row_through(
                  box,
                  {{origin[0] + shift * spacing, origin[1] + static_cast<double>(j) * row_distance * spacing, 0.0}},
                  spacing);
            }};
  }

  std::optional<Point> origin_;
};

}  // namespace

ArrangementPointer read_hexagonal(Section& section, int dimensions) {
  std::optional<Point> origin;
  if (section.has("origin")) origin = read_point(section, "origin", dimensions);
  return std::make_unique<Hexagonal>(origin);
}

}  // namespace tektite::preprocess
