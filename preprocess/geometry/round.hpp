#pragma once
// Discs and balls, with or without a round hole about the same centre.

#include "preprocess/geometry/shape.hpp"

namespace tektite::preprocess {

class RoundShape : public Shape {
 public:
  RoundShape(int dimensions, const Round& round) : dimensions_(dimensions), round_(round) {}

  int dimensions() const override { return dimensions_; }
  bool inside(const Point& x, double tolerance) const override;
  double reach(const Point& direction) const override;
  Point centre() const override { return round_.centre; }
  double measure() const override;
  std::optional<Round> round() const override { return round_; }
  Region region(const Placement& placement) const override;
  Surface surface(const Placement& placement) const override;

 private:
  int dimensions_;
  Round round_;
};

}  // namespace tektite::preprocess
