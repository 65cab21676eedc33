#pragma once

#include <fmt/format.h>

#include <optional>

#include "boundary/kernel_contact.hpp"
#include "boundary/mirror.hpp"
#include "neighbours/order.hpp"
#include "neighbours/reference_pairs.hpp"
#include "parallel/for_each_pair.hpp"
#include "passes/hold_clamped.hpp"
#include "passes/lagrangian_motion.hpp"
#include "passes/lagrangian_sums.hpp"
#include "schemes/material_passes.hpp"
#include "schemes/scheme.hpp"
#include "schemes/state_sums.hpp"

namespace tektite {

template <Space space, class Kernel>
class TotalLagrangianScheme final : public Scheme {
  static constexpr int D = dimensions_of(space);

 public:
  explicit TotalLagrangianScheme(const SchemeSetup& setup)
      : particles_(setup.particles),
        profile_(setup.profile),
        settings_(setup.settings),
        viscosity_(std::get<MonaghanViscosity>(setup.settings.viscosity)),
        materials_(setup.particles, setup.materials),
        mirror_(setup.symmetry) {
    if (settings_.contact) contact_.emplace(particles_, setup.materials, support(), setup.symmetry, *settings_.contact);
  }

  void start() override {
    auto& p = particles_;
    for (const auto field : {Field::pressure, Field::sound_speed, Field::wave_speed, Field::viscous_work,
                             Field::acceleration, Field::velocity_gradient, Field::viscous_power, Field::viscous_signal,
                             Field::reference_position, Field::reference_volume, Field::kernel_type})
      p.allocate(field);
    if (!p.has(Field::specific_internal_energy)) p.allocate(Field::specific_internal_energy);
    order_in_space<D>(p, support());
    std::ranges::copy(p.reals(Field::position), p.reals(Field::reference_position).begin());
    for (std::size_t i = 0; i < p.count(); ++i)
      p.scalars(Field::reference_volume)[i] = p.scalars(Field::mass)[i] / p.scalars(Field::density)[i];
    materials_.start();
    prepare();
    if (contact_) contact_->start();
    materials_.for_each_run([&](const auto& run) { evaluate_state(run); });
    evaluate_rates(0.0);
  }

  void restore(const std::map<std::string, double>& state) override {
    prepare();
    if (contact_) contact_->restore(state);
  }
  void save(std::map<std::string, double>& state) const override {
    if (contact_) contact_->save(state);
  }

  void step(double dt) override {
    if (contact_) {
      const auto scope = profile_.time("search");
      contact_->prepare(dt, false);
    }
    evaluate_rates(dt);
    advance(dt);
  }

  TimeStep stable_step() const override {
    const auto least = least_stable_step<D>(particles_, settings_.courant, viscosity_);
    const auto contact = contact_ ? contact_->stable_step(settings_.courant) : least;
    const auto& choice = contact.dt < least.dt ? contact : least;
    return {choice.dt, choice.reason, choice.particle};
  }

  Ledger ledger() override { return ledger_of<D>(particles_, contact_ ? contact_->energy() : 0.0); }

  bool in_contact() const override { return contact_ && contact_->touching(); }
  std::string remark() const override {
    if (uncorrected_ == 0) return {};
    return fmt::format("{} particles have too few neighbours for the correction and go without", uncorrected_);
  }

  std::size_t memory() const override {
    return pairs_.memory() + (contact_ ? contact_->memory() : 0) + reference_.capacity() * sizeof(ReferenceRecord<D>) +
           motion_.capacity() * sizeof(MotionRecord<D>) + stress_.capacity() * sizeof(StressRecord<D>) +
           2 * deformation_.capacity() * sizeof(Tensor<double, D>);
  }

 private:
  double support() const {
    const auto h = particles_.reals(Field::smoothing_length);
    return Kernel::support * *std::max_element(h.begin(), h.end());
  }

  /// Everything that follows from the reference configuration alone.
  void prepare() {
    for (const auto field : {Field::half_density, Field::half_energy, Field::half_pressure, Field::half_sound_speed,
                             Field::half_deviatoric_stress})
      particles_.allocate(field);
    materials_.allocate_scratch();
    pairs_ = reference_pairs<D>(particles_, mirror_, support());
    const auto count = particles_.count(), all = count + mirror_.images();
    reference_.resize(all);
    motion_.resize(all);
    stress_.resize(all);
    deformation_.resize(count);
    rate_.resize(count);
    for (std::size_t i = 0; i < count; ++i) {
      auto& r = reference_[i];
      r.x = particles_.template vectors<D>(Field::reference_position)[i];
      r.volume = particles_.scalars(Field::reference_volume)[i];
      r.smoothing_length = particles_.scalars(Field::smoothing_length)[i];
      r.correction.matrix = unit();
      r.correction.shift = Vector<double, D>::zero();
    }
    mirror_.fill(reference_, count);
    if (settings_.corrected) correct();
  }

  static Tensor<double, D> unit() {
    auto one = Tensor<double, D>::zero();
    for (int k = 0; k < D; ++k) one(k, k) = 1.0;
    return one;
  }

  /// The mixed correction; a particle whose matrix cannot be inverted keeps the plain gradient and is counted.
  void correct() {
    const auto count = particles_.count();
    std::vector<double> kernel(count);
    std::vector<Vector<double, D>> gradient(count);
    CorrectionSums<Kernel, D> sums{reference_.data(), false, kernel.data(), gradient.data(), rate_.data()};
    for_each_pair(pairs_, sums);
    for (std::size_t i = 0; i < count; ++i) {
      reference_[i].correction.shift = (1.0 / kernel[i]) * gradient[i];
      for (int k = 0; k < D; ++k) reference_[i].correction.matrix(k, k) = 1.0 / kernel[i];
    }
    mirror_.fill(reference_, count);
    sums.second = true;
    for_each_pair(pairs_, sums);
    uncorrected_ = 0;
    for (std::size_t i = 0; i < count; ++i) {
      auto& correction = reference_[i].correction;
      const auto& m = rate_[i];
      // K/S with K = M⁻¹; the moment of a whole neighbourhood is near the unit tensor.
      constexpr double singular = 1e-3;
      const double determinant_of_m = determinant(m);
      if (determinant_of_m > singular) {
        const auto c = cofactor(m);
        for (int a = 0; a < D; ++a)
          for (int b = 0; b < D; ++b) correction.matrix(a, b) = c(b, a) / determinant_of_m / kernel[i];
      } else {
        correction.matrix = unit();
        correction.shift = Vector<double, D>::zero();
        ++uncorrected_;
      }
    }
    mirror_.fill(reference_, count);
  }

  void evaluate_rates(double dt) {
    const double half_step = 0.5 * dt;
    auto& p = particles_;
    {
      const auto scope = profile_.time("predict");
      materials_.for_each_run([&](const auto& run) {
        run_through(run.range, PredictLagrangianMotion<D>{
                                   p.template vectors<D>(Field::position), p.template vectors<D>(Field::velocity),
                                   p.template vectors<D>(Field::acceleration), half_step, motion_.data()});
      });
      mirror_.fill(motion_, p.count());
      leave_failed_out();
    }
    {
      const auto scope = profile_.time("deformation");
      for_each_pair(pairs_,
                    DeformationSums<Kernel, D>{reference_.data(), motion_.data(), deformation_.data(), rate_.data()});
    }
    {
      const auto scope = profile_.time("stress");
      materials_.for_each_run([&](const auto& run) { evaluate_stress(run, half_step); });
      mirror_.fill(stress_, p.count());
    }
    const auto scope = profile_.time("forces");
    for_each_pair(pairs_, LagrangianForces<Kernel, MonaghanViscosity, D>{
                              reference_.data(), motion_.data(), stress_.data(), viscosity_, p.scalars(Field::mass),
                              p.template vectors<D>(Field::acceleration), p.scalars(Field::viscous_power),
                              p.scalars(Field::viscous_signal)});
    if (contact_)
      contact_->add_forces([this](std::size_t i) { return motion_[i].x; }, p.template vectors<D>(Field::acceleration));
    if (p.has(Field::clamped))
      run_through({0, p.count()},
                  HoldClamped<D>{p.integers(Field::clamped).data(), p.template vectors<D>(Field::acceleration)});
    mirror_.hold(p.template vectors<D>(Field::acceleration));
  }

  /// A failed particle leaves the sums: nobody has it for a neighbour any more (the TLAG run of Young et al. 2021).
  void leave_failed_out() {
    if (!particles_.has(Field::damage)) return;
    const double* damage = particles_.scalars(Field::damage);
    for_each(particles_.count(), [&](std::size_t i) {
      if (damage[i] >= 1.0) reference_[i].volume = 0.0;
    });
    mirror_.fill(reference_, particles_.count());
  }

  using Run = typename MaterialPasses<D, false>::Run;

  /// Stress in the middle of a step, from the deformation there.
  void evaluate_stress(const Run& run, double half_step) {
    auto& p = particles_;
    run_through(run.range,
                Deform<D>{reference_.data(), deformation_.data(), rate_.data(), p.scalars(Field::mass),
                          p.scalars(Field::reference_volume), p.scalars(Field::density),
                          p.scalars(Field::specific_internal_energy), p.scalars(Field::pressure),
                          p.template symmetrics<D>(Field::deviatoric_stress), p.scalars(Field::viscous_power),
                          half_step, stress_.data(), p.template tensors<D>(Field::velocity_gradient),
                          p.scalars(Field::half_density), p.scalars(Field::half_energy)});
    materials_.evaluate_eos(run, Field::half_density, Field::half_energy, Field::half_pressure,
                            Field::half_sound_speed);
    materials_.predict_strength(run, half_step);
    materials_.release(run, Field::half_deviatoric_stress, Field::half_pressure);
    run_through(run.range, AssembleStress<D>{p.template symmetrics<D>(Field::half_deviatoric_stress),
                                             p.scalars(Field::half_pressure), p.scalars(Field::half_density),
                                             p.scalars(Field::half_sound_speed), stress_.data()});
  }

  void advance(double dt) {
    const auto scope = profile_.time("advance");
    auto& p = particles_;
    materials_.for_each_run([&](const auto& run) {
      run_through(
          run.range,
          AdvanceLagrangianMotion<D>{
              motion_.data(), p.template symmetrics<D>(Field::half_deviatoric_stress), p.scalars(Field::half_pressure),
              p.scalars(Field::half_density), p.template vectors<D>(Field::acceleration),
              p.template tensors<D>(Field::velocity_gradient), p.scalars(Field::viscous_power), dt,
              p.template vectors<D>(Field::position), p.template vectors<D>(Field::velocity), p.scalars(Field::density),
              p.scalars(Field::specific_internal_energy), p.scalars(Field::viscous_work)});
      materials_.advance_strength(run, dt);
      materials_.advance_damage(run, dt);
      evaluate_state(run);
    });
  }

  void evaluate_state(const Run& run) const {
    materials_.evaluate_eos(run, Field::density, Field::specific_internal_energy, Field::pressure, Field::sound_speed);
    materials_.release(run, Field::deviatoric_stress, Field::pressure);
    materials_.evaluate_wave_speed(run);
  }

  Particles& particles_;
  Profile& profile_;
  SchemeSettings settings_;
  MonaghanViscosity viscosity_;
  MaterialPasses<D, false> materials_;
  Mirror<D> mirror_;
  std::optional<KernelContact<D, Kernel>> contact_;
  PairList pairs_;
  std::size_t uncorrected_ = 0;
  std::vector<ReferenceRecord<D>> reference_;
  std::vector<MotionRecord<D>> motion_;
  std::vector<StressRecord<D>> stress_;
  std::vector<Tensor<double, D>> deformation_, rate_;
};

/// One space for all kernels; each space is instantiated in a translation unit of its own.
template <Space space>
std::unique_ptr<Scheme> make_total_lagrangian_in(const SchemeSetup& setup) {
  std::unique_ptr<Scheme> scheme;
  const auto attempt = [&]<class K>(std::type_identity<K>) {
    if (K::name == setup.settings.kernel) scheme = std::make_unique<TotalLagrangianScheme<space, K>>(setup);
  };
  attempt(std::type_identity<CubicSpline>{});
  attempt(std::type_identity<WendlandC2>{});
  attempt(std::type_identity<TruncatedGaussian>{});
  return scheme;
}

}  // namespace tektite
