#pragma once

#include <fmt/format.h>

#include "boundary/anvil.hpp"
#include "core/saved_number.hpp"
#include "neighbours/neighbourhood.hpp"
#include "parallel/for_each_pair.hpp"
#include "passes/assemble_records.hpp"
#include "passes/body_contact.hpp"
#include "passes/msph_adjoint.hpp"
#include "passes/msph_motion.hpp"
#include "passes/msph_sums.hpp"
#include "passes/msph_surface.hpp"
#include "schemes/hold_still.hpp"
#include "schemes/make_scheme_in.hpp"
#include "schemes/material_passes.hpp"
#include "schemes/scheme.hpp"
#include "schemes/state_sums.hpp"

namespace tektite {

/// MSPH and SSPH: the strong form, or forces adjoint to the strain rates, with derivatives from the matrix B, central
/// differences in time (velocities live in the middle of steps), conservative smoothing.
template <Space space, class Weights, class Kernel>
class MsphScheme final : public Scheme {
  static constexpr int D = dimensions_of(space);
  static constexpr int hoops = hoops_of(space);
  static constexpr bool across = D == 2 && hoops > 0;  ///< the ring's strain is the plane's third one

 public:
  explicit MsphScheme(const SchemeSetup& setup)
      : particles_(setup.particles),
        profile_(setup.profile),
        settings_(setup.settings),
        materials_(setup.particles, setup.materials),
        neighbourhood_(setup.particles, Kernel::support * smoothing_range(setup.particles).second, setup.symmetry),
        anvil_(setup.settings.anvil) {}

  void start() override {
    for (const auto field : {Field::pressure, Field::sound_speed, Field::wave_speed, Field::viscous_work,
                             Field::acceleration, Field::velocity_gradient, Field::search_position})
      particles_.allocate(field);
    if (!particles_.has(Field::specific_internal_energy)) particles_.allocate(Field::specific_internal_energy);
    materials_.start();
    allocate_scratch();
    materials_.evaluate_state();
    neighbourhood_.prepare(0.0);
    assemble();
  }
  void restore(const std::map<std::string, double>& state) override {
    allocate_scratch();
    neighbourhood_.restore(state);
    answered_ = saved_number(state, "particle_steps");
    lower_order_ = {saved_number(state, "first_order_particle_steps"),
                    saved_number(state, "zeroth_order_particle_steps")};
    assemble();
  }
  void save(std::map<std::string, double>& state) const override {
    neighbourhood_.save(state);
    state["first_order_particle_steps"] = lower_order_.first;
    state["zeroth_order_particle_steps"] = lower_order_.second;
    state["particle_steps"] = answered_;
  }

  void step(double dt) override {
    {
      const auto scope = profile_.time("search");
      neighbourhood_.prepare(dt);
    }
    assemble();
    find_bases();
    kick(dt);
    smooth_velocity();
    find_velocity_gradients();
    advance(dt);
  }

  /// Moments, forces, smoothing of the velocity, its gradients, smoothing of the density.
  Halos halos(const std::map<std::string, double>& state) const override { return {neighbourhood_.halo(state, 5)}; }
  bool search_is_due(double dt) override { return neighbourhood_.due(dt); }
  void begin_search(double dt) override { neighbourhood_.begin(dt); }

  TimeStep stable_step() const override {
    const auto* v = particles_.template vectors<D>(Field::velocity);
    const auto least =
        least_acoustic_step<D>(particles_, settings_.courant, [v](std::size_t i) { return norm(v[i]); });  // eq. 3.22
    return {least.dt, least.reason, least.particle};
  }
  Ledger ledger() override { return ledger_sums_(particles_, 0.0); }
  bool in_contact() const override {
    return body_contact(neighbourhood_.pairs(), particles_, records_, Kernel::support);
  }
  std::string closing_remark() const override {
    if (lower_order_.first + lower_order_.second == 0.0) return {};
    return fmt::format(
        "the matrix B was ill-conditioned and answered by lower order: first order in {:.0f} and zeroth "
        "in {:.0f} particle steps",
        lower_order_.first, lower_order_.second);
  }
  std::vector<Warning> warnings() const override {
    constexpr double notable = 0.01;
    const double part = (lower_order_.first + lower_order_.second) / answered_;
    if (!(part > notable)) return {};
    return {{"singular-matrix",
             fmt::format("the matrix B was too ill-conditioned in {:.0f} % of all particle steps, and the expansion of "
                         "first or zeroth order answered: derivatives there are not those of the scheme; a larger "
                         "smoothing.ratio, or smoothing_share, which keeps particles in order, may mend it",
                         100.0 * part)}};
  }
  std::size_t memory() const override {
    return neighbourhood_.memory() + records_.capacity() * sizeof(EulerianRecord<D>) +
           coefficients_.capacity() * sizeof(MsphCoefficients<D>) +
           (lopsidedness_.capacity() + divergence_.capacity() + fitted_.capacity()) * sizeof(Vector<double, D>) +
           (kernel_mass_.capacity() + radial_part_.capacity() + across_.capacity() + heat_.capacity() +
            exchange_.capacity() + energies_.capacity() + densities_.capacity() + smoothed_.capacity() +
            material_.capacity()) *
               sizeof(double);
  }

 private:
  using Run = typename MaterialPasses<D, across>::Run;

  void allocate_scratch() {
    for (const auto field :
         {Field::half_density, Field::half_energy, Field::half_pressure, Field::half_sound_speed, Field::across_rate})
      particles_.allocate(field);
    materials_.allocate_scratch();
    const auto count = particles_.count();
    coefficients_.resize(count);
    for (auto* column : {&radial_part_, &heat_, &exchange_, &smoothed_}) column->resize(count);
    for (auto* column : {&lopsidedness_, &divergence_, &fitted_}) column->resize(count);
    held_.resize(count);
  }

  MsphGather<D> gather() const { return {records_.data()}; }

  /// What pairs see at the start of a step.
  void assemble() {
    const auto scope = profile_.time("assemble");
    auto& p = particles_;
    neighbourhood_.mirror().fit(records_, p.count());
    for_each(p.count(), [&, x = p.template vectors<D>(Field::position),
                         v = p.template vectors<D>(Field::velocity)](std::size_t i) {
      records_[i].x = x[i];
      records_[i].v = v[i];
    });
    materials_.for_each_run([&](const Run& run) {
      run_through(run.range, AssembleRecords<D, false>{
                                 p.scalars(Field::mass), p.scalars(Field::density), p.scalars(Field::pressure),
                                 p.scalars(Field::sound_speed), p.template symmetrics<D>(Field::deviatoric_stress),
                                 nullptr, nullptr, 0.0, p.scalars(Field::smoothing_length), records_.data()});
    });
    neighbourhood_.mirror().fill(records_, p.count());
    number_materials();
  }

  /// The same number for all bodies of a material.
  void number_materials() {
    material_.resize(particles_.count());
    const auto& bodies = particles_.bodies();
    for (const auto& body : bodies) {
      const auto first = std::ranges::find(bodies, body.material, &Body::material);
      std::fill(material_.begin() + static_cast<std::ptrdiff_t>(body.range.begin),
                material_.begin() + static_cast<std::ptrdiff_t>(body.range.end),
                static_cast<double>(first - bodies.begin()));
    }
    neighbourhood_.mirror().repeat(material_);
  }

  /// B of every particle, inverted; surfaces, with what they do to the stress.
  void find_bases() {
    const auto scope = profile_.time("bases");
    auto& p = particles_;
    kernel_mass_.resize(p.count());
    for_each_pair(neighbourhood_.pairs(),
                  MsphMoments<Weights, Kernel, D, hoops>{gather(), coefficients_.data(), kernel_mass_.data(),
                                                         lopsidedness_.data()});
    neighbourhood_.mirror().repeat(kernel_mass_);
    count_orders();
    run_all(MsphSurface<D>{lopsidedness_.data(), p.template vectors<D>(Field::velocity), anvil_,
                           !settings_.adjoint_forces, records_.data(), held_.data()});
    neighbourhood_.mirror().fill(records_, p.count());
  }

  void count_orders() {
    const auto of_order = [this](int order) {
      const auto tell = [this, order](std::size_t i) { return coefficients_[i].order == order; };
      return static_cast<double>(count_over(particles_, {0, particles_.count()}, tell));
    };
    answered_ += static_cast<double>(count_of_all(particles_));
    lower_order_.first += of_order(1);
    lower_order_.second += of_order(0);
  }

  void kick(double dt) {
    const auto scope = profile_.time("forces");
    if (settings_.adjoint_forces) {
      find_adjoint_forces();
      kick_by<0>(dt);
    } else {
      for_each_pair(neighbourhood_.pairs(), MsphDivergence<Weights, D>{gather(), coefficients_.data(),
                                                                       divergence_.data(), radial_part_.data()});
      kick_by<hoops>(dt);
    }
    show_velocities();
  }
  /// By the forces found, and what turning about the axis adds for `turning` directions.
  template <int turning>
  void kick_by(double dt) {
    auto& p = particles_;
    run_all(MsphKick<D, turning>{records_.data(), p.template symmetrics<D>(Field::deviatoric_stress),
                                 p.scalars(Field::pressure), divergence_.data(), radial_part_.data(), held_.data(),
                                 anvil_.axis(), dt, p.template vectors<D>(Field::velocity),
                                 p.template vectors<D>(Field::acceleration)});
    hold(p.template vectors<D>(Field::acceleration));
  }
  void find_adjoint_forces() {
    auto& p = particles_;
    const auto& mirror = neighbourhood_.mirror();
    across_.clear();
    if constexpr (hoops > 0) {
      across_.resize(p.count());
      for_each(p.count(), [&, s = p.template symmetrics<D>(Field::deviatoric_stress),
                           pressure = p.scalars(Field::pressure)](std::size_t i) {
        across_[i] = s[i].c[D == 1 ? 1 : 2] - pressure[i];
        if (records_[i].x[0] == 0.0) records_[i].stress[0] += hoops * across_[i];
      });
      mirror.repeat(across_);
      mirror.fill(records_, p.count());
    }
    mirror.fit(coefficients_, p.count());
    mirror.fill(coefficients_, p.count());
    for_each_pair(neighbourhood_.pairs(),
                  MsphAdjoint<Weights, D, hoops>{gather(), coefficients_.data(), across_.data(), divergence_.data()});
  }

  void hold(Vector<double, D>* rate) { hold_still(particles_, neighbourhood_.mirror(), rate); }

  /// The velocities, held where they have to be, as pairs see them.
  void show_velocities() {
    auto* v = particles_.template vectors<D>(Field::velocity);
    hold(v);
    for_each(particles_.count(), [&](std::size_t i) { records_[i].v = v[i]; });
    neighbourhood_.mirror().fill(records_, particles_.count());
  }

  void smooth_velocity() {
    const auto scope = profile_.time("smoothing");
    auto& p = particles_;
    const auto energy = p.reals(Field::specific_internal_energy);
    energies_.assign(energy.begin(), energy.end());
    neighbourhood_.mirror().repeat(energies_);
    for_each_pair(neighbourhood_.pairs(),
                  SmoothVelocity<Kernel, D>{gather(), kernel_mass_.data(), settings_.smoothing_share, energies_.data(),
                                            material_.data(), divergence_.data(), heat_.data(), exchange_.data()});
    hold(divergence_.data());
    run_all(MsphApplySmoothing<D>{divergence_.data(), heat_.data(), exchange_.data(), held_.data(), anvil_.axis(),
                                  p.template vectors<D>(Field::velocity), p.scalars(Field::specific_internal_energy),
                                  p.scalars(Field::viscous_work)});
    show_velocities();
  }

  void find_velocity_gradients() {
    const auto scope = profile_.time("gradients");
    for_each_pair(neighbourhood_.pairs(),
                  MsphVelocity<Weights, D>{gather(), coefficients_.data(),
                                           particles_.template tensors<D>(Field::velocity_gradient), fitted_.data()});
    hold(fitted_.data());
    for_each(particles_.count(), [&](std::size_t i) {
      if (held_[i]) fitted_[i][anvil_.axis()] = 0.0;
    });
  }

  void advance(double dt) {
    const auto scope = profile_.time("advance");
    auto& p = particles_;
    const MsphMiddle<D, hoops> middle{records_.data(),
                                      fitted_.data(),
                                      p.template symmetrics<D>(Field::deviatoric_stress),
                                      p.scalars(Field::pressure),
                                      p.scalars(Field::density),
                                      p.scalars(Field::specific_internal_energy),
                                      dt,
                                      p.template tensors<D>(Field::velocity_gradient),
                                      p.scalars(Field::across_rate),
                                      p.scalars(Field::half_density),
                                      p.scalars(Field::half_energy)};
    materials_.for_each_run([&](const Run& run) {
      run_through(run.range, middle);
      double* const pressure = materials_.scalars(run, Field::half_pressure);
      materials_.evaluate_eos(run, materials_.scalars(run, Field::half_density),
                              materials_.scalars(run, Field::half_energy), pressure,
                              materials_.scalars(run, Field::half_sound_speed));
      materials_.release(run, materials_.symmetrics(run, Field::deviatoric_stress),
                         pressure);  // or tension that is not borne does work
      run_through(run.range,
                  MsphAdvance<D, hoops>{middle, p.scalars(Field::half_pressure), anvil_,
                                        p.template vectors<D>(Field::position), p.template vectors<D>(Field::velocity),
                                        p.scalars(Field::density), p.scalars(Field::specific_internal_energy)});
      const MsphDeviatoricWork<D, hoops> deviatoric_work{middle, p.scalars(Field::specific_internal_energy)};
      run_through(run.range, deviatoric_work);
      materials_.advance_strength(run, dt);
      run_through(run.range, deviatoric_work);
    });
    smooth_density();
    materials_.evaluate_state();
  }

  void smooth_density() {
    const auto density = particles_.reals(Field::density);
    densities_.assign(density.begin(), density.end());
    neighbourhood_.mirror().repeat(densities_);
    for_each_pair(neighbourhood_.pairs(), SmoothDensity<Kernel, D>{gather(), densities_.data(), material_.data(),
                                                                   settings_.smoothing_share, smoothed_.data()});
    std::ranges::copy(smoothed_, density.begin());
  }

  template <class Pass>
  void run_all(const Pass& pass) {
    materials_.for_each_run([&](const Run& run) { run_through(run.range, pass); });
  }

  Particles& particles_;
  Profile& profile_;
  SchemeSettings settings_;
  LedgerSums<D> ledger_sums_;
  MaterialPasses<D, across> materials_;
  Neighbourhood<D> neighbourhood_;
  Anvil<D> anvil_;
  double answered_ = 0.0;                            ///< particle steps
  std::pair<double, double> lower_order_{0.0, 0.0};  ///< particle steps by first and by zeroth order
  std::vector<EulerianRecord<D>> records_;
  std::vector<MsphCoefficients<D>> coefficients_;
  std::vector<double> kernel_mass_, radial_part_, across_, heat_, exchange_, energies_, densities_, smoothed_,
      material_;
  std::vector<Vector<double, D>> lopsidedness_, divergence_, fitted_;
  std::vector<std::uint8_t> held_;
};

/// One space for both schemes and all kernels; each space is instantiated in a translation unit of its own.
template <Space space>
std::unique_ptr<Scheme> make_msph_in(const SchemeSetup& setup) {
  constexpr int D = dimensions_of(space);
  if (setup.settings.type == "msph")
    return std::make_unique<MsphScheme<space, MsphWeights<D>, TruncatedGaussian>>(setup);
  return with_kernel(setup.settings.kernel, [&]<class K>(std::type_identity<K>) {
    return std::make_unique<MsphScheme<space, SsphWeights<K, D>, K>>(setup);
  });
}

}  // namespace tektite
