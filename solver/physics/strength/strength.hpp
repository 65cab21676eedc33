#pragma once
// Strength: how the deviatoric stress answers to shear. A model gives its shear modulus G and, where it yields, the
// flow stress Y(plastic strain, plastic strain rate, temperature); advance_deviator.hpp does the rest.

#include <variant>

#include "physics/strength/elastic.hpp"
#include "physics/strength/isotropic_hardening.hpp"
#include "physics/strength/johnson_cook.hpp"
#include "physics/strength/johnson_holmquist.hpp"
#include "physics/strength/no_strength.hpp"
#include "physics/strength/perfectly_plastic.hpp"

namespace tektite {

using Strength = std::variant<NoStrength, Elastic, PerfectlyPlastic, IsotropicHardening, JohnsonCook, JohnsonHolmquist>;

}  // namespace tektite
