#pragma once

#include "passes/assemble_contact_states.hpp"
#include "passes/contact_rates.hpp"
#include "schemes/godunov_scheme.hpp"

namespace tektite {

/// Parshikov and Medin's contacts, of first order, with the time-centred energy of the time-split Godunov paper's
/// eq. 34, so that it conserves energy exactly, which the paper's own does not.
template <Space space, class Kernel>
class GodunovPmScheme final : public GodunovScheme<space, Kernel, ContactStateRecord<dimensions_of(space)>> {
  using Base = GodunovScheme<space, Kernel, ContactStateRecord<dimensions_of(space)>>;
  using Base::D;
  using Base::divergence_;
  using Base::materials_;
  using Base::neighbourhood_;
  using Base::particles_;
  using Base::power_;
  using Base::profile_;
  using Base::records_;
  using Base::smoothing_;
  using typename Base::Run;

 public:
  using Base::Base;

  Halos halos(const std::map<std::string, double>& state) const override {
    return halos_of(neighbourhood_, 1, this->contact_, state);
  }

  void step(double dt) override {
    this->search(dt);
    solve_contacts();
    this->find_contact(dt);
    advance(dt);
  }

 private:
  void solve_contacts() {
    auto& p = particles_;
    {
      const auto scope = profile_.time("assemble");
      materials_.for_each_run([&](const Run& run) {
        run_through(run.range, AssembleContactStates<D, Base::plane_stress>{
                                   p.template vectors<D>(Field::position), p.template vectors<D>(Field::velocity),
                                   p.template symmetrics<D>(Field::deviatoric_stress), p.scalars(Field::mass),
                                   p.scalars(Field::density), p.scalars(Field::pressure), p.scalars(Field::wave_speed),
                                   p.scalars(Field::smoothing_length), this->damage(), this->thickness(),
                                   shear_modulus_of(*run.material), membrane_density(), records_.data()});
      });
      neighbourhood_.mirror().fill(records_, p.count());
    }
    const auto scope = profile_.time("pairs");
    with_smoothing(smoothing_, [&](const auto& smoothing) {
      for_each_pair(neighbourhood_.pairs(),
                    ContactRates<Kernel, std::decay_t<decltype(smoothing)>, D>{
                        records_.data(), smoothing, Base::plane_stress ? membrane_density() : p.scalars(Field::density),
                        p.template vectors<D>(Field::acceleration), power_.data(), divergence_.data(),
                        p.template tensors<D>(Field::velocity_gradient), p.scalars(Field::approach_speed)});
    });
    this->hold(p.template vectors<D>(Field::acceleration));
  }

  void advance(double dt) {
    const auto scope = profile_.time("advance");
    materials_.for_each_run([&](const Run& run) {
      this->advance_motion(run, dt);
      materials_.advance_strength(run, dt, Field::density);
      materials_.advance_damage(run, dt);
      materials_.evaluate_state(run);
    });
  }

  double* membrane_density() const { return Base::plane_stress ? particles_.scalars(Field::half_density) : nullptr; }
};

/// One space for all kernels; each space is instantiated in a translation unit of its own.
template <Space space>
std::unique_ptr<Scheme> make_godunov_pm_in(const SchemeSetup& setup) {
  return with_kernel(setup.settings.kernel, [&]<class K>(std::type_identity<K>) {
    return std::make_unique<GodunovPmScheme<space, K>>(setup);
  });
}

}  // namespace tektite
