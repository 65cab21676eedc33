#pragma once

#include <optional>

#include "core/document.hpp"

namespace tektite {

/// Frictionless contact between bodies by a potential of kernel values: Young et al. (2021), eq. 15. The stiffness
/// comes from the materials: K_ca = factor · (smaller bulk modulus) / Δp^D.
struct ContactSettings {
  double factor = 0.0;
  double exponent = 0.0;  ///< n_ca
};

/// Reads [contact]; nothing where the scene has none: then bodies act on each other through the sums of the scheme.
inline std::optional<ContactSettings> read_contact(Section& root) {
  if (!root.has("contact")) return std::nullopt;
  auto section = root.section("contact");
  const std::array<std::string, 1> models{"kernel-penalty"};
  section.choice("model", models, "kernel-penalty");
  ContactSettings settings;
  settings.factor = section.quantity("factor", dimension::none, limits::positive, 0.02);
  settings.exponent = section.quantity("exponent", dimension::none, {2.0, 10.0}, 4.0);
  section.finish();
  return settings;
}

}  // namespace tektite
