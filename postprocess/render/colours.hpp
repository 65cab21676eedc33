#pragma once
// Colours of pictures.

#include <array>
#include <cstddef>

namespace tektite {

using Colour = std::array<double, 3>;  ///< red, green, blue between 0 and 1

/// Viridis, in which equal steps look equal, also to the colour-blind and in print, from 0 to 1; the end colours
/// beyond. Source: S. van der Walt and N. Smith, matplotlib (CC0); nine of its colours, interpolated in CIELAB.
const Colour& continuous_colour(double share);

/// M. Okabe and K. Ito's colours, which all eyes tell apart; they repeat.
const Colour& distinct_colour(std::size_t k);

}  // namespace tektite
