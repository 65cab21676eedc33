#pragma once
// The state of a run, and one step of it: which step is taken, why, and when a state is no longer sane.

#include <map>
#include <memory>
#include <optional>
#include <string>

#include "core/snapshot.hpp"
#include "run/run_settings.hpp"
#include "schemes/scheme.hpp"

namespace tektite {

class Simulation {
 public:
  /// From initial particles, or from a snapshot that a run left: `resumed` tells which.
  Simulation(Snapshot snapshot, RunSettings settings, bool resumed);

  /// One step. Throws RunError where the state is not sane or the time step collapses.
  void step();

  bool finished() const { return time_ >= end(); }
  double time() const { return time_; }
  std::int64_t steps() const { return steps_; }
  /// Steps taken by this process.
  std::int64_t steps_taken() const { return steps_ - first_step_number_; }
  /// When the run is over, in s; infinite while the contact that it counts from has not come.
  double end() const;
  const TimeStep& last_step() const { return last_; }
  /// The id of the particle that set the last step: its index may have changed within the step.
  std::int64_t limiting_particle() const { return limiting_; }
  std::optional<double> contact_time() const { return contact_time_; }
  /// (E - E0)/E0; where E0 is next to nothing, over the largest energy that was at play in any line of the history.
  double energy_drift(const Ledger& now) const;
  /// Over √(2 m E_kin) at the start, along the axes that neither a symmetry plane nor the anvil lies across: these take
  /// up momentum, as clamped particles do along all axes. Zero where no axis is left.
  double momentum_drift(const Ledger& now) const;
  /// Over what it would be if all turned one way, now or at the start; about the axes about which neither symmetry
  /// planes nor the anvil turn anything. None where no such axis is left, or particles are clamped.
  std::optional<double> angular_momentum_drift() const;

  const Particles& particles() const { return snapshot_.particles; }
  const RunSettings& settings() const { return settings_; }
  const Scheme& scheme() const { return *scheme_; }
  Ledger ledger() const { return scheme_->ledger(); }
  const Profile& profile() const { return profile_; }

  /// Keeps what the energies of a line of the history tell the drift. Throws RunError where they have run away.
  void note(const Ledger& line);

  /// The state as it can be saved; `state` takes what others want to keep.
  const Snapshot& save(const std::map<std::string, double>& state);

 private:
  TimeStep choose_step() const;
  void look_for_contact();
  /// det F of a particle whose density follows from it.
  double jacobian_of(std::size_t particle) const;
  /// One whose density has become negative with det F.
  std::optional<std::size_t> inverted_particle() const;
  std::string describe(std::size_t particle) const;

  Snapshot snapshot_;
  RunSettings settings_;
  Profile profile_;
  std::unique_ptr<Scheme> scheme_;
  double time_ = 0.0;
  std::int64_t steps_ = 0;
  std::int64_t first_step_number_ = 0;
  TimeStep last_;
  std::int64_t limiting_ = 0;  ///< id
  double first_step_ = 0.0;
  std::optional<double> contact_time_;
  double initial_energy_ = 0.0;
  double largest_energy_ = 0.0;  ///< at play, of the lines so far
  double momentum_scale_ = 0.0;
  std::vector<double> initial_momentum_;
  std::vector<double> initial_angular_momentum_;
  double largest_angular_momentum_ = 0.0;  ///< at the start
};

}  // namespace tektite
