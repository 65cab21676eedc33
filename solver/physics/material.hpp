#pragma once
// A material of a scene: what [material.NAME] says.

#include <map>
#include <string>

#include "core/scene.hpp"
#include "physics/damage/damage.hpp"
#include "physics/eos/eos.hpp"
#include "physics/strength/strength.hpp"

namespace tektite {

struct Material {
  std::string name;
  double density = 0.0;  ///< ρ0 in kg/m³
  Eos eos;
  Strength strength;
  Damage damage;
  double least_pressure = -limits::infinite;  ///< spall: pressure does not fall below it, Pa
};

/// K1 = ρ0 ∂p/∂ρ at rest, Pa.
inline double bulk_modulus_of(const Material& material) {
  return std::visit([rho = material.density](const auto& eos) { return rho * eos.pressure_by_density(rho, 0.0); },
                    material.eos);
}

/// μ in Pa, zero where there is no strength.
inline double shear_modulus_of(const Material& material) {
  return std::visit([](const auto& model) { return model.shear_modulus; }, material.strength);
}

/// Throws InputError where the damage is of a model that needs plastic flow and the strength has none.
inline void check_damage(const Section& section, const Material& material) {
  const bool yields = std::visit([](const auto& model) { return model.kind.yields; }, material.strength);
  if (!yields && std::holds_alternative<JohnsonCookDamage>(material.damage))
    throw section.fault("model", "it grows with plastic strain, and the material's strength does not yield",
                        "a strength that yields; spall_pressure, or none");
}

/// Reads every [material.NAME]; throws InputError.
inline std::map<std::string, Material> read_materials(Section& root) {
  std::map<std::string, Material> materials;
  for (auto& [name, section] : root.named_sections("material")) {
    Material material{name, section.quantity("density", dimension::density, limits::positive), {}, {}, {}};
    auto eos = section.section("eos");
    material.eos = Family<Eos>::read(eos);
    std::visit([&](auto& model) { model.reference_density = material.density; }, material.eos);
    auto strength = section.section_or_empty("strength");
    if (!strength.has("model")) strength.choice("model", Family<Strength>::names(), std::string(NoStrength::name));
    material.strength = Family<Strength>::read(strength);
    auto damage = section.section_or_empty("damage");
    if (!damage.has("model")) damage.choice("model", Family<Damage>::names(), std::string(NoDamage::name));
    material.damage = Family<Damage>::read(damage);
    check_damage(damage, material);
    if (section.has("spall_pressure"))
      material.least_pressure = section.quantity("spall_pressure", dimension::pressure, {-limits::infinite, 0.0});
    leave_others(section, Stage::solve);
    section.finish();
    materials[name] = material;
  }
  if (materials.empty()) throw root.fault("", "the scene has no material", "[material.NAME]");
  return materials;
}

}  // namespace tektite
