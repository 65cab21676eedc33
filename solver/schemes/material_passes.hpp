#pragma once
// Point passes that need a material: each body's range is run with its own models, chosen outside the loop.

#include "core/particles.hpp"
#include "parallel/for_each.hpp"
#include "passes/advance_strength.hpp"
#include "passes/evaluate_eos.hpp"
#include "passes/stretch_across.hpp"
#include "schemes/scheme.hpp"

namespace tektite {

template <int D, bool plane_stress>
class MaterialPasses {
 public:
  MaterialPasses(Particles& particles, const std::map<std::string, Material>& materials) : particles_(particles) {
    for (const auto& body : particles.bodies()) ranges_.push_back({body.range, &materials.at(body.material)});
  }

  /// Allocates what the materials need and sets it at the start of a run.
  void start() {
    bool yields = false, heats = false;
    for_each_strength([&](const auto& model, const Range&) {
      yields = yields || model.kind.yields;
      heats = heats || model.kind.heats;
    });
    particles_.allocate(Field::deviatoric_stress);
    if (yields) particles_.allocate(Field::plastic_strain);
    if (yields) particles_.allocate(Field::plastic_work);
    if (heats) particles_.allocate(Field::temperature);
    for_each_strength([&](const auto& model, const Range& range) {
      if constexpr (std::decay_t<decltype(model)>::kind.heats) {
        double* temperature = particles_.scalars(Field::temperature);
        for (std::size_t i = range.begin; i < range.end; ++i) temperature[i] = model.room_temperature;
      }
    });
  }

  void evaluate_eos(Field density, Field energy, Field pressure, Field sound_speed) {
    for (const auto& [range, material] : ranges_)
      std::visit(
          [&, r = range](const auto& eos) {
            for_each(r, EvaluateEos<std::decay_t<decltype(eos)>>{
                            eos, particles_.scalars(density), particles_.scalars(energy), particles_.scalars(pressure),
                            particles_.scalars(sound_speed)});
          },
          material->eos);
  }

  void evaluate_wave_speed() {
    for_each_strength([&](const auto& model, const Range& range) {
      for_each(range, EvaluateWaveSpeed{model.shear_modulus, particles_.scalars(Field::density),
                                        particles_.scalars(Field::sound_speed), particles_.scalars(Field::wave_speed)});
    });
  }

  void predict_strength(double half_step) {
    for_each_strength([&](const auto& model, const Range& range) {
      for_each(range, PredictStrength<std::decay_t<decltype(model)>, D, plane_stress>{
                          model, particles_.tensors<D>(Field::velocity_gradient), across_rate(),
                          particles_.scalars(Field::density), particles_.symmetrics<D>(Field::deviatoric_stress),
                          optional(Field::plastic_strain), optional(Field::temperature), half_step,
                          particles_.symmetrics<D>(Field::half_deviatoric_stress)});
    });
  }

  void advance_strength(double step) {
    for_each_strength([&](const auto& model, const Range& range) {
      for_each(range,
               AdvanceStrength<std::decay_t<decltype(model)>, D, plane_stress>{
                   model, particles_.tensors<D>(Field::velocity_gradient), across_rate(),
                   particles_.scalars(Field::half_density), step, particles_.symmetrics<D>(Field::deviatoric_stress),
                   optional(Field::plastic_strain), optional(Field::plastic_work), optional(Field::temperature)});
    });
  }

  /// Plane stress only: D_zz over the next `step` from the present state.
  void stretch_across(double step) requires plane_stress {
    for (const auto& [range, material] : ranges_)
      std::visit(
          [&, r = range](const auto& eos, const auto& strength) {
            for_each(r, StretchAcross<std::decay_t<decltype(eos)>, std::decay_t<decltype(strength)>>{
                            eos, strength, particles_.tensors<2>(Field::velocity_gradient),
                            particles_.symmetrics<2>(Field::deviatoric_stress), particles_.scalars(Field::density),
                            particles_.scalars(Field::specific_internal_energy), particles_.scalars(Field::pressure),
                            particles_.scalars(Field::viscous_power), optional(Field::plastic_strain),
                            optional(Field::temperature), step, particles_.scalars(Field::across_rate)});
          },
          material->eos, material->strength);
  }

 private:
  template <class Body>
  void for_each_strength(const Body& body) {
    for (const auto& [range, material] : ranges_)
      std::visit([&, r = range](const auto& model) { body(model, r); }, material->strength);
  }
  double* optional(Field field) { return particles_.has(field) ? particles_.scalars(field) : nullptr; }
  const double* across_rate() { return plane_stress ? particles_.scalars(Field::across_rate) : nullptr; }

  Particles& particles_;
  std::vector<std::pair<Range, const Material*>> ranges_;
};

}  // namespace tektite
