#pragma once
// Colours of pictures.

#include <vtkSmartPointer.h>

#include <array>
#include <cstddef>
#include <vector>

class vtkScalarsToColors;

namespace tektite {

using Colour = std::array<double, 3>;  ///< red, green, blue between 0 and 1

/// Viridis, in which equal steps look equal, also to the colour-blind and in print.
/// Source: S. van der Walt and N. Smith, matplotlib (CC0); nine of its colours, interpolated in CIELAB.
vtkSmartPointer<vtkScalarsToColors> continuous_colours(double least, double most);

/// The given colours for the numbers 0, 1, 2, ...
vtkSmartPointer<vtkScalarsToColors> listed_colours(const std::vector<Colour>& list);

/// M. Okabe and K. Ito's colours, which all eyes tell apart; they repeat.
const Colour& distinct_colour(std::size_t k);

}  // namespace tektite
