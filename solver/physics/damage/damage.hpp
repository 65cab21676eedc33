#pragma once
// Damage D grows with plastic strain; at D = 1 a particle has failed: it bears pressure, but no tension, and no
// shear either unless its strength model says how much.

#include <variant>

#include "physics/damage/johnson_cook_damage.hpp"
#include "physics/damage/johnson_holmquist_damage.hpp"
#include "physics/damage/no_damage.hpp"

namespace tektite {

using Damage = std::variant<NoDamage, JohnsonCookDamage, JohnsonHolmquistDamage>;

}  // namespace tektite
