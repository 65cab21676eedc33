#pragma once
// Point passes that need a material. The particles of each body are cut into runs; a thread takes a run through all
// passes of a stage while it lies in the cache, with the models of its material chosen outside the loops.

#include <algorithm>
#include <vector>

#include "core/particles.hpp"
#include "parallel/for_each.hpp"
#include "passes/advance_strength.hpp"
#include "passes/damage.hpp"
#include "passes/evaluate_eos.hpp"
#include "passes/stretch_across.hpp"
#include "schemes/scheme.hpp"

namespace tektite {

template <int D, bool plane_stress>
class MaterialPasses {
 public:
  struct Run {
    Range range;
    const Material* material;
  };

  MaterialPasses(Particles& particles, const std::map<std::string, Material>& materials) : particles_(particles) {
    constexpr std::size_t longest = 512;
    for (const auto& body : particles.bodies()) {
      materials_.push_back(&materials.at(body.material));
      for (std::size_t begin = body.range.begin; begin < body.range.end; begin += longest)
        runs_.push_back({{begin, std::min(begin + longest, body.range.end)}, materials_.back()});
    }
  }

  /// work(run) for every run, each on some thread.
  template <class Work>
  void for_each_run(const Work& work) const {
    for_each_uneven(runs_.size(), [&](std::size_t k) { work(runs_[k]); });
  }

  /// Allocates what the materials need and sets it at the start of a run.
  void start() {
    bool yields = false, heats = false;
    for (const auto* material : materials_)
      std::visit(
          [&](const auto& model) {
            yields = yields || model.kind.yields;
            heats = heats || model.kind.heats;
          },
          material->strength);
    particles_.allocate(Field::deviatoric_stress);
    if (yields) particles_.allocate(Field::plastic_strain);
    if (yields) particles_.allocate(Field::plastic_work);
    if (heats) particles_.allocate(Field::temperature);
    if (damages()) particles_.allocate(Field::damage);
    if (bulks()) particles_.allocate(Field::bulking_pressure);
    for (const auto& run : runs_)
      std::visit(
          [&](const auto& model) {
            if constexpr (std::decay_t<decltype(model)>::kind.heats)
              run_through(run.range, [t = particles_.scalars(Field::temperature),
                                      room = model.room_temperature](std::size_t i) { t[i] = room; });
          },
          run.material->strength);
  }

  /// Allocates what lives within a step.
  void allocate_scratch() {
    if (particles_.has(Field::damage)) particles_.allocate(Field::plastic_increment);
  }

  /// A field of a run's particles, from the first one on: as whatever lives through the passes over that run alone.
  double* scalars(const Run& run, Field field) const { return particles_.scalars(field) + run.range.begin; }
  Vector<double, D>* vectors(const Run& run, Field field) const {
    return particles_.vectors<D>(field) + run.range.begin;
  }
  Symmetric<double, D>* symmetrics(const Run& run, Field field) const {
    return particles_.symmetrics<D>(field) + run.range.begin;
  }
  Tensor<double, D>* tensors(const Run& run, Field field) const {
    return particles_.tensors<D>(field) + run.range.begin;
  }
  static Range all_of(const Run& run) { return {0, run.range.size()}; }

  /// Arrays of the run's particles, here and where others are given below.
  void evaluate_eos(const Run& run, const double* density, const double* energy, double* pressure,
                    double* sound_speed) const {
    std::visit(
        [&](const auto& eos) {
          run_through(all_of(run),
                      EvaluateEos<std::decay_t<decltype(eos)>>{eos, density, energy, pressure, sound_speed});
        },
        run.material->eos);
    if (bulking_of(*run.material) > 0.0)
      run_through(all_of(run), AddBulking{scalars(run, Field::bulking_pressure), pressure});
  }

  /// Pressure, as far as it is borne, and wave speeds of the present state.
  void evaluate_state(const Run& run) const {
    evaluate_eos(run, scalars(run, Field::density), scalars(run, Field::specific_internal_energy),
                 scalars(run, Field::pressure), scalars(run, Field::sound_speed));
    release(run, symmetrics(run, Field::deviatoric_stress), scalars(run, Field::pressure));
    evaluate_wave_speed(run);
  }

  void evaluate_state() const {
    for_each_run([this](const Run& run) { evaluate_state(run); });
  }

  void evaluate_wave_speed(const Run& run) const {
    run_through(run.range,
                EvaluateWaveSpeed{shear_modulus_of(*run.material), particles_.scalars(Field::density),
                                  particles_.scalars(Field::sound_speed), particles_.scalars(Field::wave_speed)});
  }

  void predict_strength(const Run& run, double half_step, const Tensor<double, D>* velocity_gradient,
                        Symmetric<double, D>* half_deviatoric_stress) const {
    std::visit(
        [&](const auto& model) {
          run_side_by_side(all_of(run), PredictStrength<std::decay_t<decltype(model)>, D, plane_stress>{
                                            model, velocity_gradient, optional(run, Field::across_rate),
                                            scalars(run, Field::density), symmetrics(run, Field::deviatoric_stress),
                                            optional(run, Field::plastic_strain), optional(run, Field::temperature),
                                            scalars(run, Field::pressure), optional(run, Field::damage), half_step,
                                            half_deviatoric_stress});
        },
        run.material->strength);
  }

  /// `density` is that by which the plastic work is counted per mass.
  void advance_strength(const Run& run, double step, const Tensor<double, D>* velocity_gradient,
                        const double* density) const {
    std::visit(
        [&](const auto& model) {
          run_side_by_side(all_of(run), AdvanceStrength<std::decay_t<decltype(model)>, D, plane_stress>{
                                            model, velocity_gradient, optional(run, Field::across_rate), density, step,
                                            symmetrics(run, Field::deviatoric_stress),
                                            optional(run, Field::plastic_strain), optional(run, Field::plastic_work),
                                            optional(run, Field::temperature), scalars(run, Field::pressure),
                                            optional(run, Field::damage), optional(run, Field::plastic_increment)});
        },
        run.material->strength);
  }
  void advance_strength(const Run& run, double step, Field density = Field::half_density) const {
    advance_strength(run, step, tensors(run, Field::velocity_gradient), scalars(run, density));
  }

  /// What a failed particle no longer bears, of a stress and a pressure that were just computed.
  void release(const Run& run, Symmetric<double, D>* stress, double* pressure) const {
    const bool damaged = !std::holds_alternative<NoDamage>(run.material->damage);
    const bool keeps_shear = std::visit([](const auto& model) { return model.kind.crushes; }, run.material->strength);
    if (damaged && !keeps_shear) run_through(all_of(run), ReleaseShear<D>{scalars(run, Field::damage), stress});
    if (damaged || std::isfinite(run.material->least_pressure))
      run_through(all_of(run), LimitTension{run.material->least_pressure,
                                            damaged ? scalars(run, Field::damage) : nullptr, pressure});
  }

  void advance_damage(const Run& run, double step) const {
    std::visit(
        [&](const auto& model, const auto& strength) {
          using Model = std::decay_t<decltype(model)>;
          using StrengthModel = std::decay_t<decltype(strength)>;
          if constexpr (!std::is_same_v<Model, NoDamage>) {
            const AdvanceDamage<Model, D> advance{model,
                                                  particles_.scalars(Field::plastic_increment),
                                                  particles_.scalars(Field::pressure),
                                                  particles_.symmetrics<D>(Field::deviatoric_stress),
                                                  optional(Field::temperature),
                                                  step,
                                                  particles_.scalars(Field::damage)};
            if constexpr (requires { model.bulking; } && StrengthModel::kind.shears) {
              if (model.bulking > 0.0)
                return run_through(run.range, AdvanceDamageAndBulk<Model, StrengthModel, D>{
                                                  advance, strength, bulk_modulus_of(*run.material),
                                                  particles_.scalars(Field::bulking_pressure)});
            }
            run_through(run.range, advance);
          }
        },
        run.material->damage, run.material->strength);
  }

  /// Plane stress only: D_zz over the next `step` from the present state.
  void stretch_across(const Run& run, double step) const requires plane_stress {
    std::visit(
        [&](const auto& eos, const auto& strength) {
          run_through(run.range,
                      StretchAcross<std::decay_t<decltype(eos)>, std::decay_t<decltype(strength)>>{
                          eos, strength, particles_.tensors<2>(Field::velocity_gradient),
                          particles_.symmetrics<2>(Field::deviatoric_stress), particles_.scalars(Field::density),
                          particles_.scalars(Field::specific_internal_energy), particles_.scalars(Field::pressure),
                          particles_.scalars(Field::viscous_power), optional(Field::bulking_pressure),
                          optional(Field::plastic_strain), optional(Field::temperature), optional(Field::damage), step,
                          particles_.scalars(Field::across_rate)});
        },
        run.material->eos, run.material->strength);
  }

 private:
  bool damages() const {
    return std::ranges::any_of(
        materials_, [](const Material* material) { return !std::holds_alternative<NoDamage>(material->damage); });
  }
  static double bulking_of(const Material& material) {
    return std::visit(
        [](const auto& model) {
          if constexpr (requires { model.bulking; })
            return model.bulking;
          else
            return 0.0;
        },
        material.damage);
  }
  bool bulks() const {
    return std::ranges::any_of(materials_, [](const Material* material) { return bulking_of(*material) > 0.0; });
  }
  double* optional(Field field) const { return particles_.has(field) ? particles_.scalars(field) : nullptr; }
  double* optional(const Run& run, Field field) const { return particles_.has(field) ? scalars(run, field) : nullptr; }

  Particles& particles_;
  std::vector<const Material*> materials_;  ///< of all bodies, also of those that have no particle here
  std::vector<Run> runs_;
};

}  // namespace tektite
