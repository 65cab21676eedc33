// union, difference, intersection of `parts`, a list of shapes. What is inside is decided by the parts' own tests; the
// size comes from the exact regions or surfaces of the parts.

#include <algorithm>
#include <optional>

#include "preprocess/geometry/registry.hpp"
#include "preprocess/geometry/shapes.hpp"

namespace tektite::preprocess {
namespace {

enum class Operation { join, subtract, intersect };

class Boolean final : public Shape {
 public:
  Boolean(Operation operation, std::vector<ShapePointer> parts, int dimensions)
      : operation_(operation), parts_(std::move(parts)), dimensions_(dimensions) {
    measure_ = dimensions == 2 ? region({}).area() : surface({}).volume();
  }

  int dimensions() const override { return dimensions_; }

  bool inside(const Point& x, double tolerance) const override {
    bool result = parts_[0]->inside(x, tolerance);
    for (std::size_t k = 1; k < parts_.size(); ++k)
      result = combine(result, parts_[k]->inside(x, part_tolerance(tolerance)));
    return result;
  }

  void mark(const Row& row, double tolerance, std::span<std::uint8_t> marks) const override {
    parts_[0]->mark(row, tolerance, marks);
    std::vector<std::uint8_t> other(row.count);
    for (std::size_t k = 1; k < parts_.size(); ++k) {
      parts_[k]->mark(row, part_tolerance(tolerance), other);
      for (std::size_t i = 0; i < row.count; ++i) marks[i] = combine(marks[i] != 0, other[i] != 0) ? 1 : 0;
    }
  }

  double reach(const Point& direction) const override {
    double result = parts_[0]->reach(direction);
    for (std::size_t k = 1; k < parts_.size(); ++k) {
      const double part = parts_[k]->reach(direction);
      if (operation_ == Operation::join) result = std::max(result, part);
      if (operation_ == Operation::intersect) result = std::min(result, part);
    }
    return result;
  }

  double measure() const override { return measure_; }

  std::vector<std::string> remarks() const override {
    std::vector<std::string> all;
    for (const auto& part : parts_)
      for (const auto& remark : part->remarks()) all.push_back(remark);
    return all;
  }

  Region region(const Placement& placement) const override {
    auto result = parts_[0]->region(placement);
    for (std::size_t k = 1; k < parts_.size(); ++k) result = combine(result, parts_[k]->region(placement));
    return result;
  }

  Surface surface(const Placement& placement) const override {
    auto result = parts_[0]->surface(placement);
    for (std::size_t k = 1; k < parts_.size(); ++k) result = combine(result, parts_[k]->surface(placement));
    return result;
  }

 private:
  /// What is taken away must not take the common edge with it: it shrinks where the whole grows.
  double part_tolerance(double tolerance) const { return operation_ == Operation::subtract ? -tolerance : tolerance; }

  bool combine(bool a, bool b) const {
    if (operation_ == Operation::join) return a || b;
    return operation_ == Operation::subtract ? a && !b : a && b;
  }

  template <class Solid>
  Solid combine(const Solid& a, const Solid& b) const {
    if (operation_ == Operation::join) return a.joined(b);
    return operation_ == Operation::subtract ? a.without(b) : a.common(b);
  }

  Operation operation_;
  std::vector<ShapePointer> parts_;
  int dimensions_;
  double measure_ = 0.0;
};

ShapePointer read_boolean(Section& section, int dimensions, Operation operation) {
  std::vector<ShapePointer> parts;
  for (auto& part : section.list("parts")) parts.push_back(read_shape(part, dimensions));
  if (parts.size() < 2) throw section.fault("parts", "a boolean needs at least two parts");
  std::optional<InputError> failure;
  try {
    auto shape = std::make_unique<Boolean>(operation, std::move(parts), dimensions);
    if (shape->measure() > 0.0) return shape;
  } catch (const InputError& fault) {
    failure = section.fault("parts", fault.what());
  }
  throw failure ? *failure : section.fault("parts", "nothing is left of these parts");
}

}  // namespace

ShapePointer read_union(Section& section, int dimensions) { return read_boolean(section, dimensions, Operation::join); }

ShapePointer read_difference(Section& section, int dimensions) {
  return read_boolean(section, dimensions, Operation::subtract);
}

ShapePointer read_intersection(Section& section, int dimensions) {
  return read_boolean(section, dimensions, Operation::intersect);
}

}  // namespace tektite::preprocess
