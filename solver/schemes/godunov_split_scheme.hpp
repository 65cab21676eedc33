#pragma once

#include "passes/deviatoric_rates.hpp"
#include "passes/hydrodynamic_rates.hpp"
#include "passes/velocity_gradient.hpp"
#include "physics/eos/shock_slope.hpp"
#include "schemes/godunov_scheme.hpp"
#include "schemes/godunov_settings.hpp"
#include "schemes/mixed_correction.hpp"

namespace tektite {

/// A step goes through the paper's two halves one after the other. The deviatoric half changes velocities and energies
/// by the deviatoric stress, and the stress by the velocity gradient after it; the hydrodynamic half solves the Riemann
/// problems. The gradients that second order needs are summed up beside the deviatoric forces, from the state at the
/// start of the step: that of the velocity lacks the change by the deviatoric half, a term of second order in what is
/// reconstructed. With the mixed correction every sum over pairs takes its gradients, found anew for the places of each
/// search, and the gradient of the velocity, by which the pressures are advanced, is that behind the deviatoric half.
template <Space space, class Kernel>
class GodunovSplitScheme final : public GodunovScheme<space, Kernel, HydrodynamicRecord<dimensions_of(space)>> {
  using Base = GodunovScheme<space, Kernel, HydrodynamicRecord<dimensions_of(space)>>;
  using Base::contact_;
  using Base::D;
  using Base::deviatoric_acceleration_;
  using Base::divergence_;
  using Base::materials_;
  using Base::neighbourhood_;
  using Base::particles_;
  using Base::power_;
  using Base::profile_;
  using Base::records_;
  using Base::settings_;
  using Base::smoothing_;
  using typename Base::Run;

 public:
  explicit GodunovSplitScheme(const SchemeSetup& setup) : Base(setup), godunov_(*setup.settings.godunov) {
    for (const auto& [name, material] : setup.materials)
      shock_slope_[&material] = std::visit([](const auto& eos) { return shock_slope(eos); }, material.eos);
  }

  void step(double dt) override {
    for (int part = 0; part < parts(); ++part) step_part(part, dt);
  }
  int parts() const override { return godunov_.strang ? 2 : 1; }
  void step_part(int part, double dt) override {
    const double of_deviator = godunov_.strang ? 0.5 * dt : dt;
    if (part > 0) return finish_symmetrically(of_deviator);
    this->search(dt);
    find_correction();
    kick_by_deviator(of_deviator, true);
    if (settings_.corrected_eulerian && godunov_.order == 2) find_gradient_after_kick();
    solve_contacts(dt);
    this->find_contact(dt);
    advance(dt, of_deviator);
  }

  std::string remark() const override { return remark_on_correction(without_of_all(particles_, without_)); }
  std::vector<Warning> warnings() const override {
    return few_neighbours(without_of_all(particles_, without_), count_of_all(particles_));
  }

  Halos halos(const std::map<std::string, double>& state) const override {
    const int sweeps = !settings_.corrected_eulerian ? 2 : godunov_.order == 2 ? 4 : 3;
    return halos_of(neighbourhood_, sweeps, this->contact_, state);
  }

  std::size_t memory() const override {
    return Base::memory() + deviatoric_.capacity() * sizeof(DeviatoricRecord<D>) +
           corrections_.capacity() * sizeof(CorrectionRecord<D>);
  }

 private:
  void resize_records() override {
    Base::resize_records();
    neighbourhood_.mirror().fit(deviatoric_, particles_.count());
  }

  /// Corrections at the places and volumes of now.
  void find_correction() {
    if (!settings_.corrected_eulerian) return;
    const auto scope = profile_.time("correction");
    auto& p = particles_;
    neighbourhood_.mirror().fit(corrections_, p.count());
    for_each(p.count(), [this, &p](std::size_t i) {
      const double area_density = membrane<Base::plane_stress>(this->thickness(), i) * p.scalars(Field::density)[i];
      corrections_[i] = {p.template vectors<D>(Field::position)[i], p.scalars(Field::mass)[i] / area_density,
                         p.scalars(Field::smoothing_length)[i], Correction<double, D>::none()};
    });
    neighbourhood_.mirror().fill(corrections_, p.count());
    without_ =
        correction_.find(neighbourhood_.pairs(), neighbourhood_.mirror(), corrections_, p.count(), nullptr, Owned(p));
  }

  /// sweep(smoothing, gradients) with what the pairs of this scene have.
  template <class Sweep>
  void with_gradients(const Sweep& sweep) const {
    if (settings_.corrected_eulerian)
      sweep(MeanSmoothing{}, CorrectedGradients<Kernel, D>{corrections_.data(), {settings_.correction_limit}});
    else
      with_smoothing(smoothing_, [&](const auto& smoothing) { sweep(smoothing, PlainGradients<D>{}); });
  }

  /// The first half of eq. 21 with eq. 32.
  void kick_by_deviator(double dt, bool with_gradients) {
    auto& p = particles_;
    assemble_deviatoric();
    {
      const auto scope = profile_.time("deviatoric pairs");
      if (with_gradients && godunov_.order == 2)
        sum_deviator<2>();
      else
        sum_deviator<1>();
    }
    const auto scope = profile_.time("kick");
    auto* const acceleration = p.template vectors<D>(Field::acceleration);
    this->hold(acceleration);
    std::copy_n(acceleration, deviatoric_acceleration_.size(), deviatoric_acceleration_.begin());
    materials_.for_each_run([&](const Run& run) {
      run_through(run.range, KickDeviatoric<D>{acceleration, power_.data(), dt, p.template vectors<D>(Field::velocity),
                                               p.scalars(Field::specific_internal_energy)});
    });
  }

  /// That of the velocity that the kick leaves.
  void find_gradient_after_kick() {
    find_velocity_gradient();
    const auto* const gradient = particles_.template tensors<D>(Field::velocity_gradient);
    for_each(particles_.count(), [this, gradient](std::size_t i) { records_[i].velocity_gradient = gradient[i]; });
  }

  void find_velocity_gradient() {
    assemble_deviatoric();
    const auto scope = profile_.time("velocity gradients");
    with_gradients([&]<class Smoothing, class Gradients>(const Smoothing& smoothing, const Gradients& gradients) {
      for_each_pair(neighbourhood_.pairs(), VelocityGradient<Kernel, Smoothing, D, Gradients>{
                                                deviatoric_.data(), smoothing,
                                                particles_.template tensors<D>(Field::velocity_gradient), gradients});
    });
  }

  void assemble_deviatoric() {
    const auto scope = profile_.time("assemble");
    auto& p = particles_;
    materials_.for_each_run([&](const Run& run) {
      run_through(run.range, AssembleDeviatoric<D, Base::plane_stress>{
                                 p.template vectors<D>(Field::position), p.template vectors<D>(Field::velocity),
                                 p.template symmetrics<D>(Field::deviatoric_stress), p.scalars(Field::mass),
                                 p.scalars(Field::density), p.scalars(Field::pressure), this->thickness(),
                                 p.scalars(Field::smoothing_length), deviatoric_.data()});
    });
    neighbourhood_.mirror().fill(deviatoric_, p.count());
  }

  template <int order>
  void sum_deviator() {
    with_gradients([&]<class Smoothing, class Gradients>(const Smoothing& smoothing, const Gradients& gradients) {
      for_each_pair(neighbourhood_.pairs(),
                    DeviatoricRates<Kernel, Smoothing, D, order, Gradients>{
                        deviatoric_.data(), smoothing, particles_.template vectors<D>(Field::acceleration),
                        power_.data(), records_.data(), gradients});
    });
  }

  /// The rates of the second half: eq. 21, 22 and 34.
  void solve_contacts(double dt) {
    assemble_hydrodynamic();
    const auto scope = profile_.time("hydrodynamic pairs");
    std::visit(
        [&](const auto& solver) {
          if (godunov_.order == 1)
            sum_contacts(dt, solver, NoReconstruction{});
          else
            std::visit([&](const auto& limiter) { sum_contacts(dt, solver, limiter); }, godunov_.limiter);
        },
        godunov_.riemann);
    this->hold(particles_.template vectors<D>(Field::acceleration));
  }

  void assemble_hydrodynamic() {
    const auto scope = profile_.time("assemble");
    auto& p = particles_;
    materials_.for_each_run([&](const Run& run) {
      double* const pressure = materials_.scalars(run, Field::half_pressure);
      materials_.evaluate_eos(run, materials_.scalars(run, Field::density),
                              materials_.scalars(run, Field::specific_internal_energy), pressure,
                              materials_.scalars(run, Field::half_sound_speed));
      materials_.release(run, materials_.symmetrics(run, Field::deviatoric_stress), pressure);
      run_through(run.range,
                  AssembleHydrodynamic<D, Base::plane_stress>{
                      p.template vectors<D>(Field::position), p.template vectors<D>(Field::velocity),
                      p.scalars(Field::mass), p.scalars(Field::density), p.scalars(Field::half_pressure),
                      p.scalars(Field::half_sound_speed), this->thickness(), p.scalars(Field::smoothing_length),
                      this->damage(), shock_slope_.at(run.material), records_.data()});
    });
    neighbourhood_.mirror().fill(records_, p.count());
  }

  template <class Solver, class Limiter>
  void sum_contacts(double dt, const Solver& solver, const Limiter& limiter) {
    auto& p = particles_;
    with_gradients([&]<class Smoothing, class Gradients>(const Smoothing& smoothing, const Gradients& gradients) {
      for_each_pair(neighbourhood_.pairs(),
                    HydrodynamicRates<Kernel, Smoothing, D, Solver, Limiter, Gradients>{
                        records_.data(), smoothing, solver, limiter, dt, p.template vectors<D>(Field::acceleration),
                        power_.data(), divergence_.data(), p.template tensors<D>(Field::velocity_gradient),
                        p.scalars(Field::approach_speed), gradients});
    });
  }

  /// The state at the end of the step; the deviatoric stress and the damage only of `part` of it.
  void advance(double dt, double part) {
    const auto scope = profile_.time("advance");
    materials_.for_each_run([&](const Run& run) {
      this->advance_motion(run, dt);
      advance_stress(run, part);
      materials_.evaluate_state(run);
    });
  }

  void advance_stress(const Run& run, double dt) const {
    materials_.advance_strength(run, dt, Field::density);
    materials_.advance_damage(run, dt);
  }

  /// Strang: the second half of the deviatoric step, its parts in the opposite order.
  void finish_symmetrically(double part) {
    this->search(0.0);
    find_correction();
    find_velocity_gradient();
    materials_.for_each_run([&](const Run& run) {
      advance_stress(run, part);
      materials_.release(run, materials_.symmetrics(run, Field::deviatoric_stress),
                         materials_.scalars(run, Field::pressure));
    });
    kick_by_deviator(part, false);
    materials_.evaluate_state();
    this->place_records();
  }

  GodunovSettings godunov_;
  std::map<const Material*, double> shock_slope_;
  std::vector<DeviatoricRecord<D>> deviatoric_;
  MixedCorrection<Kernel, D> correction_{least_moment_of_pieces<D>};
  std::vector<CorrectionRecord<D>> corrections_;
  std::size_t without_ = 0;  ///< particles that go without correction
};

/// One space for all kernels; each space is instantiated in a translation unit of its own.
template <Space space>
std::unique_ptr<Scheme> make_godunov_split_in(const SchemeSetup& setup) {
  return with_kernel(setup.settings.kernel, [&]<class K>(std::type_identity<K>) {
    return std::make_unique<GodunovSplitScheme<space, K>>(setup);
  });
}

}  // namespace tektite
