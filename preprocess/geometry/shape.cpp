#include "preprocess/geometry/shape.hpp"

#include <stdexcept>

namespace tektite::preprocess {
namespace {

/// A shape that answers every question in the place where it was before the motion.
class Placed final : public Shape {
 public:
  Placed(ShapePointer shape, const Placement& placement) : shape_(std::move(shape)), placement_(placement) {}

  int dimensions() const override { return shape_->dimensions(); }
  bool inside(const Point& x, double tolerance) const override {
    return shape_->inside(placement_.apply_inverse(x), tolerance);
  }
  void mark(const Row& row, double tolerance, std::span<std::uint8_t> inside) const override {
    shape_->mark({placement_.apply_inverse(row.start), placement_.turn_inverse(row.step), row.count}, tolerance,
                 inside);
  }
  double reach(const Point& direction) const override {
    return shape_->reach(placement_.turn_inverse(direction)) + dot(direction, placement_.apply(Point{}));
  }
  Point centre() const override { return placement_.apply(shape_->centre()); }
  double measure() const override { return shape_->measure(); }
  std::optional<Round> round() const override {
    auto round = shape_->round();
    if (round) round->centre = placement_.apply(round->centre);
    return round;
  }
  Region region(const Placement& outer) const override { return shape_->region(outer.after(placement_)); }
  Surface surface(const Placement& outer) const override { return shape_->surface(outer.after(placement_)); }
  std::vector<std::string> remarks() const override { return shape_->remarks(); }

 private:
  ShapePointer shape_;
  Placement placement_;
};

}  // namespace

void Shape::mark(const Row& row, double tolerance, std::span<std::uint8_t> marks) const {
  for (std::size_t k = 0; k < row.count; ++k) marks[k] = inside(row.at(k), tolerance) ? 1 : 0;
}

Point Shape::centre() const {
  const auto box = bounds();
  return 0.5 * (box.lower + box.upper);
}

Region Shape::region(const Placement&) const { throw std::logic_error("this shape is no region of the plane"); }
Surface Shape::surface(const Placement&) const { throw std::logic_error("this shape is no solid"); }

Box Shape::bounds() const {
  Box box;
  for (int k = 0; k < dimensions(); ++k) {
    Point axis{};
    axis[k] = 1.0;
    box.upper[k] = reach(axis);
    axis[k] = -1.0;
    box.lower[k] = -reach(axis);
  }
  return box;
}

ShapePointer placed(ShapePointer shape, const Placement& placement) {
  if (placement.is_identity() || shape->move(placement)) return shape;
  return std::make_unique<Placed>(std::move(shape), placement);
}

}  // namespace tektite::preprocess
