#pragma once

#include <optional>

#include "core/document.hpp"

namespace tektite {

/// Frictionless contact between bodies by a potential of kernel values: Young et al. (2021), eq. 15. The stiffness
/// comes from the materials: K_ca = factor · (smaller bulk modulus) / Δp^D.
struct ContactSettings {
  double factor = 0.0;
  int exponent = 0;       ///< n_ca
  bool itself = false;    ///< also between pieces of one body
  bool at_faces = false;  ///< bodies push each other from where their faces touch, not from where kernels meet
};

/// Reads [contact]; nothing where the scene has none: then bodies act on each other through the sums of the scheme.
/// `lagrangian` says whether bodies have total-Lagrangian kernels, which do not see their own pieces come near.
inline std::optional<ContactSettings> read_contact(Section& root, bool lagrangian) {
  if (!root.has("contact")) return std::nullopt;
  auto section = root.section("contact");
  const std::array<std::string, 1> models{"kernel-penalty"};
  section.choice("model", models, "kernel-penalty");
  ContactSettings settings;
  settings.factor = section.quantity("factor", dimension::none, limits::positive, 0.02);
  settings.exponent = static_cast<int>(section.integer("exponent", {2.0, 10.0}, 4));
  settings.itself = section.flag("itself", false);
  const std::array<std::string, 2> begins{"in-reach", "at-faces"};
  settings.at_faces = section.choice("begins", begins, "in-reach") == "at-faces";
  if (settings.itself && !lagrangian)
    throw section.fault("itself", "Eulerian kernels see pieces of their own body in the sums of the scheme",
                        "false, or one of the schemes total-lagrangian and adaptle");
  section.finish();
  return settings;
}

}  // namespace tektite
