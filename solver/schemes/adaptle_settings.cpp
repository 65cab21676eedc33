#include "schemes/adaptle_settings.hpp"

#include <algorithm>
#include <array>

namespace tektite {

Conversion read_conversion(Section& scheme) {
  const std::array<std::string, 3> kinds{"none", "strain", "damage"};  // in the order of Conversion::By
  const auto kind = scheme.choice("conversion", kinds);
  Conversion conversion;
  conversion.by = static_cast<Conversion::By>(std::ranges::find(kinds, kind) - kinds.begin());
  if (conversion.by == Conversion::By::strain)
    conversion.strain = scheme.quantity("conversion_strain", dimension::none, limits::positive);
  return conversion;
}

ArtificialStress read_artificial_stress(Section section, Space space, bool meets) {
  if (!is_plane(space))
    throw section.fault({}, "artificial stress is defined by the principal stresses in a plane",
                        "space = plane-strain or plane-stress");
  ArtificialStress stress;
  stress.epsilon = section.quantity("epsilon", dimension::none, {0.0, 1.0}, stress.epsilon);
  stress.exponent = static_cast<int>(section.integer("exponent", {1.0, 10.0}, stress.exponent));
  if (meets) {
    const std::array<std::string, 3> ways{"none", "both", "eulerian"};  // in the order of ArtificialStressInterface
    const auto way = section.choice("interface", ways, "both");
    stress.interface = static_cast<ArtificialStressInterface>(std::ranges::find(ways, way) - ways.begin());
  }
  section.finish();
  return stress;
}

}  // namespace tektite
