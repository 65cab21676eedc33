#pragma once
// Schemes at work on a uniform lattice of an elastic metal, as their linear analysis takes them.

#include <string>

#include "run/run_settings.hpp"
#include "stability/amplification.hpp"

namespace tektite::test {

inline constexpr double metal_modulus = 79e9;  // K, Pa

/// Settings of a scene with this material and what `scheme` says (of [scheme], [viscosity], [smoothing]).
inline RunSettings lattice_settings(const std::string& space, const std::string& scheme) {
  auto document =
      Document::parse("name = 'lattice'\nspace = '" + space + "'\ntime.end = 1.0\n" + scheme +
                          "\n[material.metal]\ndensity = 2785.0\neos = { model = 'linear', bulk_modulus = 79e9 }\n"
                          "strength = { model = 'elastic', shear_modulus = 27.6e9 }\n",
                      "test scene");
  return read_run_settings(document);
}

inline const std::string no_viscosity = "viscosity = { model = 'monaghan', alpha = 0.0, beta = 0.0 }\n";

/// The lattice of the metal at this h/δ, stretched alike in all directions to a mean stress in Pa.
inline LatticeState stressed(const RunSettings& settings, double ratio, double stress) {
  const int dimensions = dimensions_of(settings.scene.space);
  return {"metal", ratio, deformation_for(settings.materials.at("metal"), dimensions, stress)};
}

/// Of the time step in use: the integration in time lets waves grow by a part of Δt³, which is out of the way here.
inline constexpr double short_step = 0.1;

/// Growth times δ/c above which a mode counts as growing at such steps.
inline constexpr double growing = 1e-4;

}  // namespace tektite::test
