#pragma once

#include <cstdint>

#include "core/scene.hpp"
#include "physics/artificial_stress.hpp"

namespace tektite {

/// By what a total-Lagrangian particle turns into an Eulerian one, with its neighbours: Young et al. (2021),
/// section 2.3.
struct Conversion {
  enum class By { none, strain, damage };
  By by = By::none;
  double strain = 0.0;  ///< the equivalent logarithmic strain beyond which it turns
};

/// Reads the keys `conversion` and `conversion_strain` of [scheme].
Conversion read_conversion(Section& scheme);

/// Reads [scheme.artificial_stress]; the key `interface` only where total-Lagrangian and Eulerian particles meet.
ArtificialStress read_artificial_stress(Section section, Space space, bool meets);

}  // namespace tektite
