#pragma once

#include <fmt/format.h>
#include <array>
#include <catch2/catch.hpp>
#include <cmath>
#include <string>

namespace tektite::test {

/// Prints the errors of three runs, each at half the spacing of the one before, and gives the order of the last two.
inline double convergence(const std::string& what, const std::array<double, 3>& errors) {
  const double first = std::log2(errors[0] / errors[1]), last = std::log2(errors[1] / errors[2]);
  WARN(fmt::format("{}: errors {:.3g} {:.3g} {:.3g}, orders {:.2f} {:.2f}", what, errors[0], errors[1], errors[2],
                   first, last));
  return last;
}

}  // namespace tektite::test
