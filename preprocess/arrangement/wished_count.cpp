#include <algorithm>
#include <cmath>

#include "preprocess/arrangement/registry.hpp"

namespace tektite::preprocess {
namespace {

/// Keeps the spacing that came nearest to the wish; of two that are equally near, the first.
class Nearest {
 public:
  explicit Nearest(std::size_t wished) : wished_(wished) {}

  /// True where the count is still below the wish.
  bool try_spacing(const Arrangement& arrangement, const Shape& shape, double spacing) {
    const auto count = arrangement.count(shape, spacing);
    const auto miss = count > wished_ ? count - wished_ : wished_ - count;
    if (spacing_ == 0.0 || miss < miss_) {
      spacing_ = spacing;
      miss_ = miss;
    }
    return count < wished_;
  }
  bool exact() const { return spacing_ > 0.0 && miss_ == 0; }
  double spacing() const { return spacing_; }

 private:
  std::size_t wished_;
  std::size_t miss_ = 0;
  double spacing_ = 0.0;
};

}  // namespace

double spacing_for_count(const Arrangement& arrangement, const Shape& shape, std::size_t wished) {
  const double cell = shape.measure() / (static_cast<double>(wished) * arrangement.cell_factor());
  const double guess = std::pow(cell, 1.0 / shape.dimensions());
  double fine = guess, coarse = guess;
  Nearest nearest(wished);
  // The guess is off by no more than a surface layer; where a body is only a few spacings large that may be a factor.
  constexpr double widening = 1.05;
  constexpr int most_widenings = 40;
  for (int k = 0; k < most_widenings && nearest.try_spacing(arrangement, shape, fine); ++k) fine /= widening;
  for (int k = 0; k < most_widenings && !nearest.try_spacing(arrangement, shape, coarse); ++k) coarse *= widening;
  constexpr int halvings = 40;  // to 1e-12 of the spacing, where rounding begins
  for (int k = 0; k < halvings && !nearest.exact(); ++k) {
    const double middle = 0.5 * (fine + coarse);
    (nearest.try_spacing(arrangement, shape, middle) ? coarse : fine) = middle;
  }
  return nearest.spacing();
}

}  // namespace tektite::preprocess
