#include "postprocess/accuracy/convergence.hpp"

#include <cmath>

namespace tektite {
namespace {

constexpr double safety_factor = 1.25;  // Celik et al. (2008), eq. 7: three resolutions
constexpr double largest_order = 64.0;  // beyond it the finest two results differ by less than rounding shows
constexpr int halvings = 200;           // of the interval of orders: to the last bit

/// The root of a function that is positive at zero and falls through zero once.
template <class Function>
double root_of(const Function& function) {
  double below = 0.0, above = largest_order;
  for (int k = 0; k < halvings; ++k) {
    const double middle = 0.5 * (below + above);
    (function(middle) > 0.0 ? below : above) = middle;
  }
  return 0.5 * (below + above);
}

}  // namespace

std::optional<double> observed_order(const Sample& coarse, const Sample& fine) {
  if (!(coarse.value > 0.0) || !(fine.value > 0.0) || coarse.spacing == fine.spacing) return std::nullopt;
  return std::log(coarse.value / fine.value) / std::log(coarse.spacing / fine.spacing);
}

std::optional<double> fitted_order(std::span<const Sample> errors) {
  double mean_x = 0.0, mean_y = 0.0;
  for (const auto& [spacing, error] : errors) {
    if (!(error > 0.0)) return std::nullopt;
    mean_x += std::log(spacing) / static_cast<double>(errors.size());
    mean_y += std::log(error) / static_cast<double>(errors.size());
  }
  double xx = 0.0, xy = 0.0;
  for (const auto& [spacing, error] : errors) {
    const double x = std::log(spacing) - mean_x;
    xx += x * x;
    xy += x * (std::log(error) - mean_y);
  }
  if (errors.size() < 2 || xx == 0.0) return std::nullopt;
  return xy / xx;
}

Extrapolation extrapolate(const std::array<Sample, 3>& results) {
  const auto& [fine, middle, coarse] = results;
  const double r21 = middle.spacing / fine.spacing, r32 = coarse.spacing / middle.spacing;
  const double e21 = middle.value - fine.value, e32 = coarse.value - middle.value;
  if (e21 == 0.0 || e32 == 0.0) return {};
  const double s = e32 / e21 > 0.0 ? 1.0 : -1.0;
  const auto excess = [&](double p) {
    // As p goes to zero with s = 1 the quotient goes to ln r21 / ln r32.
    const double quotient =
        p == 0.0 && s > 0.0 ? std::log(r21) / std::log(r32) : (std::pow(r21, p) - s) / (std::pow(r32, p) - s);
    return std::log(std::abs(e32 / e21)) + std::log(quotient) - p * std::log(r21);
  };
  if (!(excess(0.0) > 0.0)) return {Approach::diverging};
  const double p = root_of(excess);
  const double growth = std::pow(r21, p) - 1.0;
  return {s > 0.0 ? Approach::monotone : Approach::oscillatory, p, fine.value - e21 / growth,
          safety_factor * std::abs(e21) / growth};
}

}  // namespace tektite
