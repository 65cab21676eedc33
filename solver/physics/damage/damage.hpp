#pragma once
// Damage D grows with plastic strain; at D = 1 a particle has failed: it bears pressure, but neither shear nor tension.

#include <variant>

#include "physics/damage/johnson_cook_damage.hpp"
#include "physics/damage/no_damage.hpp"

namespace tektite {

using Damage = std::variant<NoDamage, JohnsonCookDamage>;

}  // namespace tektite
