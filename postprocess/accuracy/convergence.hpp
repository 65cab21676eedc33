#pragma once
// How fast a result changes with the spacing, and what that says of the result at spacing zero. Pure functions.

#include <array>
#include <optional>
#include <span>

namespace tektite {

/// A result at a spacing.
struct Sample {
  double spacing = 0.0;  ///< in m, positive
  double value = 0.0;
};

/// The order p in error ~ spacing^p that two errors show: ln(e1/e2) / ln(h1/h2). Nullopt where an error is not positive
/// or the spacings are equal.
std::optional<double> observed_order(const Sample& coarse, const Sample& fine);

/// The same from any number of errors: the slope of the line of least squares through (ln h, ln e). Nullopt where there
/// are fewer than two, an error is not positive, or all spacings are equal.
std::optional<double> fitted_order(std::span<const Sample> errors);

/// How three results approach each other.
enum class Approach {
  monotone,     ///< each change smaller than the one before, of the same sign
  oscillatory,  ///< smaller, of the other sign
  diverging,    ///< not smaller than the spacings explain: nothing can be extrapolated
  unchanged     ///< two results are equal: no order can be seen
};

struct Extrapolation {
  Approach approach = Approach::unchanged;
  // Of a monotone or oscillatory approach; zero otherwise.
  double order = 0.0;
  double value = 0.0;        ///< at spacing zero
  double uncertainty = 0.0;  ///< grid convergence index of the finest result, in its unit
};

/// Richardson's extrapolation and the grid convergence index from three results, finest first, spacings rising.
/// Source: Celik, Ghia, Roache, Freitas, Coleman and Raad (2008), J. Fluids Eng. 130, 078001, eqs. 3 to 7, with their
/// safety factor 1.25. The index is given in the unit of the value: their relative one times the finest result. Their
/// eq. 3a takes an absolute value, by which a diverging sequence would have an order; that is told apart here.
Extrapolation extrapolate(const std::array<Sample, 3>& results);

}  // namespace tektite
