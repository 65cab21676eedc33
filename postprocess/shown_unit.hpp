#pragma once
// SI values in the unit in which an engineer reads them: 2.1e-2 m as 21 mm, 1.94e10 Pa as 19.4 GPa.

#include <string>

namespace tektite {

struct ShownUnit {
  double factor = 1.0;  ///< shown value = SI value * factor
  std::string label;    ///< empty for a plain number
};

/// The unit with the largest prefix in which `magnitude` (SI, of either sign) is at least 1.
ShownUnit shown_unit(double magnitude, const std::string& si_unit);

}  // namespace tektite
