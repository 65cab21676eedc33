#pragma once

#include <fmt/format.h>

#include <optional>

#include "boundary/kernel_contact.hpp"
#include "boundary/mirror.hpp"
#include "boundary/stop_at_anvil.hpp"
#include "boundary/walls.hpp"
#include "core/counted.hpp"
#include "neighbours/order.hpp"
#include "passes/lagrangian_motion.hpp"
#include "passes/lagrangian_sums.hpp"
#include "passes/least_stretch.hpp"
#include "passes/viscous_step_limit.hpp"
#include "schemes/converter.hpp"
#include "schemes/eulerian_part.hpp"
#include "schemes/half_state.hpp"
#include "schemes/hold_still.hpp"
#include "schemes/hourglass_control.hpp"
#include "schemes/interface_forces.hpp"
#include "schemes/kept_deformation.hpp"
#include "schemes/lagrangian_rings.hpp"
#include "schemes/make_scheme_in.hpp"
#include "schemes/material_passes.hpp"
#include "schemes/reference_correction.hpp"
#include "schemes/reference_neighbours.hpp"
#include "schemes/scheme.hpp"
#include "schemes/state_sums.hpp"

namespace tektite {

/// Kernels of the reference configuration; for the scheme adaptle also particles with Eulerian kernels, coupled as in
/// Young et al. (2021), section 2.2: a total-Lagrangian particle sums over its neighbours of the reference
/// configuration, for which Eulerian ones among them have a deformation gradient there (eq. 13), and an Eulerian
/// particle sums over those of the present one. Each sum is of one kind, so that it is consistent; in return what two
/// particles of different kinds do to each other is equal and opposite only as far as both descriptions agree.
template <Space space, class Kernel>
class TotalLagrangianScheme final : public Scheme {
  static constexpr int D = dimensions_of(space);
  static constexpr bool rings = hoops_of(space) > 0;
  using Neighbours = ReferenceNeighbours<Kernel, D>;

 public:
  explicit TotalLagrangianScheme(const SchemeSetup& setup)
      : particles_(setup.particles),
        profile_(setup.profile),
        settings_(setup.settings),
        materials_(setup.particles, setup.materials),
        mirror_(setup.symmetry),
        anvil_(setup.settings.anvil),
        walls_(walls_of(setup.symmetry, setup.settings.anvil)),
        converter_(setup.settings.conversion, setup.refresh),
        interface_(setup.settings) {
    if (settings_.contact) contact_.emplace(particles_, setup.materials, support(), setup.symmetry, *settings_.contact);
    if (settings_.type == "adaptle") eulerian_.emplace(particles_, support(), setup.symmetry, settings_);
  }

  void start() override {
    auto& p = particles_;
    for (const auto field :
         {Field::pressure, Field::sound_speed, Field::wave_speed, Field::viscous_work, Field::acceleration,
          Field::viscous_power, Field::viscous_signal, Field::reference_position, Field::reference_volume,
          Field::kernel_type, Field::least_stretch})
      p.allocate(field);
    if (eulerian_) p.allocate(Field::velocity_gradient);
    if (!p.has(Field::specific_internal_energy)) p.allocate(Field::specific_internal_energy);
    order_in_space<D>(p, support());
    std::ranges::copy(p.reals(Field::position), p.reals(Field::reference_position).begin());
    for (std::size_t i = 0; i < p.count(); ++i)
      p.scalars(Field::reference_volume)[i] = p.scalars(Field::mass)[i] / p.scalars(Field::density)[i];
    materials_.start();
    prepare();
    if (eulerian_) eulerian_->start();
    if (contact_) contact_->start();
    materials_.evaluate_state();
    evaluate_rates(0.0, false);
  }

  void restore(const std::map<std::string, double>& state) override {
    prepare();
    if (eulerian_) eulerian_->restore(state);
    if (contact_) contact_->restore(state);
    if (hourglass_) hourglass_->restore(state);
  }
  void save(std::map<std::string, double>& state) const override {
    if (eulerian_) eulerian_->save(state);
    if (contact_) contact_->save(state);
    if (hourglass_) hourglass_->save(state);
  }

  void step(double dt) override {
    {
      const auto scope = profile_.time("search");
      if (contact_) contact_->prepare(dt, false);
      if (eulerian_) eulerian_->prepare(dt);
    }
    evaluate_rates(dt, true);
    anvil_.stop(particles_, dt);
    advance(dt);
    anvil_.rest(particles_);
    if (converts()) convert();
  }

  /// One sweep for F, and one for what follows from it; those of Eulerian particles read what follows from F, too.
  Halos halos(const std::map<std::string, double>& state) const override {
    const auto places = particles_.has(Field::reference_position) ? Field::reference_position : Field::position;
    Halos halos;
    if (eulerian_) halos = eulerian_->halos(state);
    if (!halos.empty()) halos.push_back({support(), places, true});
    halos.push_back({2.0 * support(), places});
    if (contact_) halos.push_back(contact_->halo(state));
    return halos;
  }
  bool search_is_due(double dt) override {
    return (contact_ && contact_->search_is_due(dt)) || (eulerian_ && eulerian_->search_is_due(dt));
  }
  void begin_search(double dt) override {
    if (search_is_left_) return eulerian_->begin_search(dt);
    if (contact_ && contact_->search_is_due(dt)) contact_->begin_search(dt);
    if (eulerian_ && eulerian_->search_is_due(dt)) eulerian_->begin_search(dt);
  }
  bool search_is_left() const override { return search_is_left_; }

  TimeStep stable_step() const override {
    const auto viscosity = coefficients_of(settings_.viscosity);
    auto least = least_stable_step<D>(particles_, settings_.courant, viscosity);
    const ViscousStepLimit<D> viscous{particles_.integers(Field::id).data(),
                                      settings_.courant,
                                      viscosity.alpha,
                                      viscosity.beta,
                                      !eulerian_,
                                      particles_.scalars(Field::smoothing_length),
                                      particles_.scalars(Field::sound_speed),
                                      particles_.scalars(Field::viscous_signal),
                                      particles_.scalars(Field::least_stretch)};
    least = reduce(particles_, least, viscous, TimeStepLimit<D>::join);
    return smallest_step<D>(least, particles_, walls_, contact_, settings_.courant);
  }

  Ledger ledger() override {
    auto ledger = ledger_sums_(particles_, contact_ ? contact_->energy() : 0.0);
    if (hourglass_) ledger.hourglass = hourglass_->energy();
    return ledger;
  }

  bool in_contact() const override { return contact_ && contact_->touching(); }
  std::string remark() const override {
    std::string text;
    if (eulerian_ && eulerian_->any()) text = "Eulerian: " + counted(eulerian_->count(), "particle");
    const auto other = remark_on_correction(without_correction());
    return text + (text.empty() || other.empty() ? "" : "; ") + other;
  }
  std::vector<Warning> warnings() const override {
    return few_neighbours(without_correction(), count_of_all(particles_));
  }

  std::size_t memory() const override {
    return neighbours_.memory() + (contact_ ? contact_->memory() : 0) + (eulerian_ ? eulerian_->memory() : 0) +
           reference_.capacity() * sizeof(ReferenceRecord<D>) + motion_.capacity() * sizeof(MotionRecord<D>) +
           stress_.capacity() * sizeof(StressRecord<D>) + correction_.memory() + (kept_ ? kept_->memory() : 0) +
           shift_.capacity() * sizeof(ShiftRecord<D>) + strain_rates_.capacity() * sizeof(StrainRateRecord<D>) +
           deformation_.capacity() * sizeof(Tensor<double, D>) + rings_.memory() + interface_.memory() +
           (hourglass_ ? hourglass_->memory() : 0);
  }

 private:
  std::size_t without_correction() const {
    return without_of_all(particles_, correction_.without() + (eulerian_ ? eulerian_->without_correction() : 0));
  }
  bool converts() const { return settings_.conversion.by != Conversion::By::none; }
  double support() const { return Kernel::support * smoothing_range(particles_).second; }

  /// Everything that follows from the reference configuration alone.
  void prepare() {
    for (const auto field : {Field::half_density, Field::half_power, Field::growth_rate}) particles_.allocate(field);
    // Rings, and Eulerian particles, whose L is known after the forces only, read the half state later.
    if (rings || eulerian_) HalfState<D>::allocate(particles_);
    if constexpr (rings) particles_.allocate(Field::across_rate);
    materials_.allocate_scratch();
    const bool all_listed = settings_.corrected || eulerian_ || rings;
    const bool controlled = settings_.hourglass_control > 0.0;
    neighbours_.find(particles_, mirror_, support(), !rings,
                     all_listed ? Neighbours::Lists::all : Neighbours::Lists::off_lattice);
    const auto count = particles_.count(), all = count + mirror_.images();
    reference_.resize(all);
    motion_.resize(all);
    stress_.resize(all);
    if (settings_.corrected || eulerian_) shift_.assign(all, {Vector<double, D>::zero(), Vector<double, D>::zero()});
    if (reconstructs(settings_.viscosity)) strain_rates_.resize(all);
    if (converts()) deformation_.resize(count);
    for (std::size_t i = 0; i < count; ++i) {
      auto& r = reference_[i];
      r.x = particles_.template vectors<D>(Field::reference_position)[i];
      r.volume = particles_.scalars(Field::reference_volume)[i];
      r.smoothing_length = particles_.scalars(Field::smoothing_length)[i];
    }
    if (controlled) hourglass_.emplace(count, materials_, settings_.hourglass_control);
    if constexpr (rings) {
      rings_.prepare(particles_, reference_);
      if (controlled) hourglass_->turn_into_rings(rings_.circumference_of_each());
    }
    if (settings_.corrected && failed_leave()) {
      kept_.emplace(particles_);
      for (std::size_t i = 0; i < count; ++i)
        if (kept_->has_left(i)) reference_[i].volume = 0.0;
    }
    note_kernel_types();
    note_volumes();
    if (eulerian_)
      drop_pairs();
    else if (settings_.corrected && failed_leave())
      neighbours_.keep([](std::size_t) { return true; });  // what is left beside failed particles is corrected anew
    else
      neighbours_.drop_lists_of_lattices();
  }

  /// What follows from who has a volume: failed particles without one are in no sum. With corrections and offsets that
  /// count them, what is missing in the sums beside them would be a strain, and of a piece that turns a large one.
  void note_volumes() {
    if constexpr (rings) rings_.find_offsets(neighbours_.pairs(), mirror_, reference_);
    // Where particles may fail they leave pieces: with a smaller moment the gradients are several times too large, and
    // other ones each time that a neighbour fails.
    if (settings_.corrected)
      correction_.find(neighbours_.pairs(), mirror_, reference_, particles_.count(),
                       failed_leave() ? least_moment_of_pieces<D> : least_moment_of_reference, Owned(particles_));
    if (kept_) kept_->turn(reference_, correction_);
  }

  /// F in the middle of a step, and its rate.
  void find_deformation() {
    const ListedRecords<D> read{reference_.data(), motion_.data()};
    sweep(read, [this]<bool corrected, class Records>(const Records& records) {
      return DeformationSums<Kernel, D, corrected, Records>{{records, reference_.data(), correction_.data()},
                                                            stress_.data()};
    });
    if (kept_) kept_->add_to(stress_, reference_, particles_.count());
  }

  /// Copies who is Eulerian into the records: an Eulerian particle has its volume, also where it had failed before and
  /// left the sums. Says whether there is such a one.
  bool note_kernel_types() {
    const auto types = particles_.integers(Field::kernel_type);
    const auto* volume = particles_.scalars(Field::reference_volume);
    const auto note = [&](bool& any, std::size_t i) {
      auto& r = reference_[i];
      r.lagrangian = types[i] == static_cast<std::int64_t>(KernelType::total_lagrangian) ? 1.0 : 0.0;
      if (r.lagrangian != 0.0 || r.volume != 0.0) return;
      r.volume = volume[i];
      any = true;
    };
    const bool any = reduce(particles_.count(), false, note, either);
    mirror_.fill(reference_, particles_.count());
    return any;
  }

  /// Drops the reference neighbours of Eulerian particles that have no total-Lagrangian one among them any more.
  void drop_pairs() {
    neighbours_.keep([this](std::size_t i) { return reference_[i].lagrangian != 0.0; });
    if constexpr (D == 2) interface_.list(neighbours_.pairs(), mirror_, reference_, particles_.count());
  }

  /// Runs the pass that make.operator()<corrected>(records) gives over all pairs of the reference configuration; it
  /// reads those records.
  template <class Make>
  void sweep(const ListedRecords<D>& records, const Make& make) const {
    if (settings_.corrected)
      neighbours_.sweep(records, [&](const auto& r) { return make.template operator()<true>(r); });
    else
      neighbours_.sweep(records, [&](const auto& r) { return make.template operator()<false>(r); });
  }

  void convert() {
    const auto scope = profile_.time("conversion");
    if (!converter_.convert(particles_, neighbours_.pairs(), mirror_, reference_, deformation_, stress_)) return;
    search_is_left_ = distributed(particles_);
    if (search_is_left_) return;  // it builds all of this anew
    const bool come_back = note_kernel_types();
    if (come_back || kept_) note_volumes();  // what is kept is not of those that have turned Eulerian
    if (contact_) contact_->note_conversion();
    drop_pairs();
    eulerian_->renew();
  }

  void evaluate_rates(double dt, bool advances) {
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
      find_deformation();
      if constexpr (rings)
        rings_.stretch(neighbours_.pairs(), mirror_, reference_, motion_, stress_, p.scalars(Field::across_rate));
    }
    {
      const auto scope = profile_.time("stress");
      materials_.for_each_run([&](const auto& run) { evaluate_stress(run, dt, advances); });
      mirror_.fill(stress_, p.count());
      if (settings_.corrected) mirror_.fill(shift_, p.count());
      if (reconstructs(settings_.viscosity)) mirror_.fill(strain_rates_, p.count());
    }
    const auto scope = profile_.time("forces");
    const ListedRecords<D> read{reference_.data(), motion_.data(),
                                stress_.data(),    settings_.corrected ? shift_.data() : nullptr,
                                nullptr,           reconstructs(settings_.viscosity) ? strain_rates_.data() : nullptr};
    std::visit(
        [&]<class Chosen>(const Chosen& viscosity) {
          sweep(read, [&]<bool corrected, class Records>(const Records& records) {
            return LagrangianForces<Kernel, Chosen, D, corrected, Records>{{records, reference_.data()},
                                                                           viscosity,
                                                                           stress_.data(),
                                                                           shift_.data(),
                                                                           p.scalars(Field::mass),
                                                                           p.template vectors<D>(Field::acceleration),
                                                                           p.scalars(Field::viscous_power),
                                                                           p.scalars(Field::viscous_signal)};
          });
        },
        settings_.viscosity);
    if constexpr (rings)
      rings_.add_forces(neighbours_.pairs(), mirror_, reference_, p.scalars(Field::mass),
                        p.template vectors<D>(Field::acceleration));
    if (hourglass_) {
      const auto hourglass_scope = profile_.time("hourglass");
      hourglass_->add_forces(neighbours_, mirror_, reference_, motion_, p, p.template vectors<D>(Field::acceleration),
                             dt);
    }
    if (eulerian_) {
      if constexpr (D == 2) interface_.add(p, mirror_, reference_, motion_, stress_, shift_);
      eulerian_->evaluate(motion_, reference_);
    }
    if (contact_)
      contact_->add_forces([this](std::size_t i) { return motion_[i].x; }, p.template vectors<D>(Field::acceleration));
    hold_still(p, mirror_, p.template vectors<D>(Field::acceleration));
  }

  /// Whether a failed particle leaves the sums, so that nobody has it for a neighbour any more (the TLAG run of Young
  /// et al. 2021). Where failed particles become Eulerian instead, they bear what is left of them there.
  bool failed_leave() const {
    return particles_.has(Field::damage) && settings_.conversion.by != Conversion::By::damage;
  }
  void leave_failed_out() {
    if (!failed_leave()) return;
    const double* damage = particles_.scalars(Field::damage);
    const auto count = particles_.count();
    const auto leaves = [&](std::size_t i) {
      return damage[i] >= 1.0 && reference_[i].lagrangian != 0.0 && reference_[i].volume != 0.0;
    };
    if (!reduce(
            count, false, [&](bool& any, std::size_t i) { any = any || leaves(i); }, either))
      return;
    if (kept_) {
      find_deformation();
      kept_->note(neighbours_.pairs(), mirror_, reference_, stress_, count, leaves);
    }
    for_each(count, [&](std::size_t i) {
      if (leaves(i)) reference_[i].volume = 0.0;
    });
    mirror_.fill(reference_, count);
    note_volumes();
    if (kept_) {
      find_deformation();
      kept_->keep(stress_, correction_);
    }
  }

  using Run = typename MaterialPasses<D, rings>::Run;

  /// Stress in the middle of a step of dt, from the deformation there, and if the step `advances` at its end too: of
  /// total-Lagrangian particles nothing that comes later changes it, and L need not be kept.
  void evaluate_stress(const Run& run, double dt, bool advances) {
    const double half_step = 0.5 * dt;
    const auto& m = materials_;
    const auto all = m.all_of(run);
    const auto first = run.range.begin;
    const auto* const reference = reference_.data() + first;
    auto* const records = stress_.data() + first;
    double* const density = m.scalars(run, Field::half_density);
    const HalfState<D> half(particles_, run.range);
    run_through(
        all, Deform<D, rings>{reference, m.scalars(run, Field::mass), m.scalars(run, Field::reference_volume),
                              m.scalars(run, Field::density), m.scalars(run, Field::specific_internal_energy),
                              m.scalars(run, Field::pressure), m.symmetrics(run, Field::deviatoric_stress),
                              m.scalars(run, Field::viscous_power), rings ? rings_.stretch_of_each() + first : nullptr,
                              across_rate(run), half_step, records, converts() ? deformation_.data() + first : nullptr,
                              half.velocity_gradient, density, half.energy});
    run_through(all, FindLeastStretch<D>{reference, records, m.scalars(run, Field::least_stretch), !eulerian_});
    m.evaluate_eos(run, density, half.energy, half.pressure, half.sound_speed);
    m.predict_strength(run, half_step, half.velocity_gradient, half.deviatoric_stress);
    m.release(run, half.deviatoric_stress, half.pressure);
    run_through(all, AssembleStress<D>{half.deviatoric_stress, half.pressure, density, half.sound_speed, records});
    if (reconstructs(settings_.viscosity))
      run_through(all, NoteStrainRates<D>{half.velocity_gradient, strain_rates_.data() + first});
    if constexpr (rings) rings_.turn_stress(particles_, run.range, reference_, stress_);
    if (!eulerian_) {
      find_power(run, half);
      if (advances) m.advance_strength(run, dt, half.velocity_gradient, density);
    }
    if (settings_.corrected)
      run_through(all, WeighStress<D, true>{reference, correction_.data() + first, records, shift_.data() + first});
    else
      run_through(all, WeighStress<D, false>{reference, nullptr, records, nullptr});
  }

  void find_power(const Run& run, const HalfState<D>& half) {
    const auto& m = materials_;
    run_through(m.all_of(run), PowerAndGrowth<D, rings>{half.deviatoric_stress, half.pressure, half.velocity_gradient,
                                                        across_rate(run), m.scalars(run, Field::half_power),
                                                        m.scalars(run, Field::growth_rate)});
  }

  double* across_rate(const Run& run) { return rings ? materials_.scalars(run, Field::across_rate) : nullptr; }

  void advance(double dt) {
    const auto scope = profile_.time("advance");
    auto& p = particles_;
    materials_.for_each_run([&](const auto& run) {
      if (eulerian_) find_power(run, HalfState<D>(p, run.range));  // the L of Eulerian particles is new
      run_through(run.range,
                  AdvanceLagrangianMotion<D>{
                      reference_.data(), motion_.data(), p.scalars(Field::half_power), p.scalars(Field::growth_rate),
                      p.scalars(Field::half_density), p.template vectors<D>(Field::acceleration),
                      p.scalars(Field::viscous_power), dt, p.template vectors<D>(Field::position),
                      p.template vectors<D>(Field::velocity), p.scalars(Field::density),
                      p.scalars(Field::specific_internal_energy), p.scalars(Field::viscous_work)});
      if (eulerian_) materials_.advance_strength(run, dt);
      materials_.advance_damage(run, dt);
      materials_.evaluate_state(run);
    });
  }

  Particles& particles_;
  Profile& profile_;
  SchemeSettings settings_;
  LedgerSums<D> ledger_sums_;
  MaterialPasses<D, rings> materials_;  ///< the ring's strain is the third one of the section
  Mirror<D> mirror_;
  std::optional<KernelContact<D, Kernel>> contact_;
  StopAtAnvil<D> anvil_;
  std::vector<SymmetryPlane> walls_;
  LagrangianRings<Kernel> rings_;  ///< of an axisymmetric space
  Neighbours neighbours_;
  std::vector<ReferenceRecord<D>> reference_;
  std::vector<MotionRecord<D>> motion_;
  std::vector<StressRecord<D>> stress_;
  ReferenceCorrection<Kernel, D> correction_;        ///< where a scene asks for it
  std::optional<KeptDeformation<Kernel, D>> kept_;   ///< with it, where failed particles leave
  std::vector<StrainRateRecord<D>> strain_rates_;    ///< where the viscosity reads them
  std::vector<ShiftRecord<D>> shift_;                ///< where there are corrections, and in adaptle
  std::vector<Tensor<double, D>> deformation_;       ///< F of the last step, for the conversion of adaptle
  std::optional<EulerianPart<Kernel, D>> eulerian_;  ///< of the scheme adaptle
  Converter<D> converter_;
  bool search_is_left_ = false;        ///< of distributed particles, some of which have just turned Eulerian
  InterfaceForces<Kernel> interface_;  ///< of the scheme adaptle, in the plane
  std::optional<HourglassControl<Kernel, D>> hourglass_;
};

/// One space for all kernels; each space is instantiated in a translation unit of its own.
template <Space space>
std::unique_ptr<Scheme> make_total_lagrangian_in(const SchemeSetup& setup) {
  return with_kernel(setup.settings.kernel, [&]<class K>(std::type_identity<K>) {
    return std::make_unique<TotalLagrangianScheme<space, K>>(setup);
  });
}

}  // namespace tektite
