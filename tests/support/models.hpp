#pragma once
// Every registered model of a family with realistic parameters, read as a scene's would be, for tests that hold for all
// of them. A model that is new in a family's list does not compile here until it has its line below.

#include <fmt/format.h>
#include <array>
#include <catch2/catch.hpp>
#include <string>
#include <string_view>
#include <type_traits>
#include <variant>

#include "core/document.hpp"
#include "physics/damage/damage.hpp"
#include "physics/eos/eos.hpp"
#include "physics/limiters/limiter.hpp"
#include "physics/model.hpp"
#include "physics/riemann/riemann.hpp"
#include "physics/strength/strength.hpp"
#include "physics/viscosity/viscosity.hpp"

namespace tektite::test {

/// kg/m³, of every equation of state here.
inline constexpr double reference_density = 2785.0;

/// Parameters of a model, each set as the keys of a scene.
template <class Model>
struct Samples;

using Texts = std::string_view;

template <>
struct Samples<LinearEos> {
  static constexpr std::array<Texts, 1> all{"bulk_modulus = '79 GPa'"};
};
template <>
struct Samples<PolynomialEos> {
  static constexpr std::array<Texts, 2> all{"k1 = '79 GPa'", "k1 = '220 GPa'\nk2 = '361 GPa'\nk3 = '10 GPa'"};
};
template <>
struct Samples<StiffenedGas> {
  static constexpr std::array<Texts, 2> all{"bulk_sound_speed = '5328 m/s'\ngrueneisen = 2.0",
                                            "bulk_sound_speed = '3940 m/s'\ngrueneisen = 1.0"};
};
template <>
struct Samples<MieGrueneisen> {
  static constexpr std::array<Texts, 2> all{"bulk_sound_speed = '5328 m/s'\nhugoniot_slope = 1.338\ngrueneisen = 2.0",
                                            "bulk_sound_speed = '5328 m/s'\nhugoniot_slope = 1.338\ngrueneisen = 0.0"};
};
template <>
struct Samples<MieGrueneisenCubic> {
  static constexpr std::array<Texts, 2> all{
      "bulk_sound_speed = '5240 m/s'\ns1 = 1.4\ngrueneisen = 1.97\nvolume_correction = 0.48",
      "bulk_sound_speed = '4578 m/s'\ns1 = 1.33\ns2 = 0.4\ns3 = -0.3\ngrueneisen = 1.67\nvolume_correction = 0.43"};
};
template <>
struct Samples<MieGrueneisenIsothermal> {
  static constexpr std::array<Texts, 1> all{"bulk_sound_speed = '5328 m/s'\nhugoniot_slope = 1.338"};
};
template <>
struct Samples<IdealGas> {
  static constexpr std::array<Texts, 1> all{"heat_ratio = 1.4"};
};
template <>
struct Samples<NoStrength> {
  static constexpr std::array<Texts, 1> all{""};
};
template <>
struct Samples<Elastic> {
  static constexpr std::array<Texts, 1> all{"shear_modulus = '27.6 GPa'"};
};
template <>
struct Samples<PerfectlyPlastic> {
  static constexpr std::array<Texts, 1> all{"shear_modulus = '27.6 GPa'\nyield_stress = '0.3 GPa'"};
};
template <>
struct Samples<IsotropicHardening> {
  static constexpr std::array<Texts, 1> all{
      "shear_modulus = '76.9 GPa'\nyield_stress = '315 MPa'\nplastic_modulus = '16.2 GPa'"};
};
template <>
struct Samples<JohnsonCook> {
  static constexpr std::array<Texts, 2> all{
      "shear_modulus = '27.6 GPa'\na = '265 MPa'\nb = '426 MPa'\nn = 0.34\nc = 0.015\nm = 1.0\n"
      "melting_temperature = '775 K'\nspecific_heat = '875 J/(kg K)'",
      "shear_modulus = '77 GPa'\na = '792 MPa'\nb = '510 MPa'\nn = 0.26\nc = 0.014\nm = 1.03\n"
      "melting_temperature = '1793 K'\nspecific_heat = '477 J/(kg K)'\ntaylor_quinney = 1.0"};
};
template <>
struct Samples<JohnsonHolmquist> {
  static constexpr std::array<Texts, 1> all{
      "shear_modulus = '193 GPa'\ntensile_limit = '-750 MPa'\np1 = '2.5 GPa'\ns1 = '7.1 GPa'\np2 = '10 GPa'\n"
      "s2 = '12.2 GPa'\nfailed_slope = 0.4\nfailed_strength = '1.3 GPa'\nc = 0.009"};
};
template <>
struct Samples<NoDamage> {
  static constexpr std::array<Texts, 1> all{""};
};
template <>
struct Samples<JohnsonCookDamage> {
  static constexpr std::array<Texts, 2> all{
      "d1 = 0.45\nd4 = 0.0138",
      "d1 = 0.05\nd2 = 3.44\nd3 = -2.12\nd4 = 0.002\nd5 = 0.61\nmelting_temperature = '1793 K'"};
};
template <>
struct Samples<JohnsonHolmquistDamage> {
  static constexpr std::array<Texts, 2> all{
      "tensile_limit = '-750 MPa'\nmost_strain = 0.8\nmost_pressure = '99.75 GPa'",
      "tensile_limit = '-750 MPa'\nmost_strain = 0.8\nmost_pressure = '99.75 GPa'\nbulking = 0.5"};
};
template <>
struct Samples<MonaghanViscosity> {
  static constexpr std::array<Texts, 2> all{"", "alpha = 0.5\nbeta = 0.0"};
};
template <>
struct Samples<LimitedViscosity> {
  static constexpr std::array<Texts, 2> all{"", "alpha = 2.0\nbeta = 1.0"};
};

template <>
struct Samples<AcousticRiemann> {
  static constexpr std::array<Texts, 1> all{""};
};
template <>
struct Samples<TwoShockRiemann> {
  static constexpr std::array<Texts, 1> all{""};
};
template <>
struct Samples<ExactRiemann> {
  static constexpr std::array<Texts, 1> all{""};
};
template <>
struct Samples<SwebyLimiter> {
  static constexpr std::array<Texts, 3> all{"", "beta = 1.0", "beta = 1.5"};
};
template <>
struct Samples<MonotonizedCentralLimiter> {
  static constexpr std::array<Texts, 1> all{""};
};
template <>
struct Samples<VanLeerLimiter> {
  static constexpr std::array<Texts, 1> all{""};
};

/// A model as a scene with these parameters has it; throws InputError.
template <class Family_, class Model>
Model model_from(std::string_view parameters) {
  auto document = Document::parse(fmt::format("model = '{}'\n{}", Model::name, parameters), "sample");
  auto root = document.root();
  auto model = std::get<Model>(Family<Family_>::read(root));
  if constexpr (requires { model.reference_density; }) model.reference_density = reference_density;
  return model;
}

/// body(std::type_identity<Model>) for every model of a family.
template <class... Models, class Body>
void for_each_model(std::type_identity<std::variant<Models...>>, const Body& body) {
  (body(std::type_identity<Models>{}), ...);
}

/// body(model) for every sample of every model of a family.
template <class Family_, class Body>
void for_each_sample(const Body& body) {
  for_each_model(std::type_identity<Family_>{}, [&]<class Model>(std::type_identity<Model>) {
    for (const auto parameters : Samples<Model>::all) {
      INFO(Model::name << "\n" << parameters);
      body(model_from<Family_, Model>(parameters));
    }
  });
}

}  // namespace tektite::test
