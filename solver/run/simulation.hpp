#pragma once
// The state of a run, and one step of it: which step is taken, why, and when a state is no longer sane.

#include <functional>
#include <map>
#include <memory>
#include <optional>
#include <string>

#include "core/snapshot.hpp"
#include "parallel/distribution.hpp"
#include "run/angular_momentum.hpp"
#include "run/run_settings.hpp"
#include "schemes/scheme.hpp"

namespace tektite {

class Simulation {
 public:
  /// From initial particles, or from a snapshot that a run left: `resumed` tells which. Of several ranks each has a
  /// part of the particles (snapshot_on_ranks.hpp), and calls the same of all that stands below.
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
  /// The id of the particle that set the last step.
  std::int64_t limiting_particle() const { return last_.particle; }
  std::optional<double> contact_time() const { return contact_time_; }
  /// (E - E0)/E0; where E0 is next to nothing, over the largest energy that was at play in any line of the history.
  double energy_drift(const Ledger& now) const;
  /// Over √(2 m E_kin) at the start, along the axes that neither a symmetry plane nor the anvil lies across: these take
  /// up momentum, as clamped particles do along all axes. Zero where no axis is left.
  double momentum_drift(const Ledger& now) const;
  /// Over what it would be if all turned one way, now or at the start; about the axes about which neither symmetry
  /// planes nor the anvil turn anything. None where no such axis is left, or particles are clamped.
  std::optional<double> angular_momentum_drift() const;

  /// Those of this rank.
  const Particles& particles() const { return snapshot_.particles; }
  /// look(particles) with those of this rank and copies of all others that it may take for their neighbours.
  void look(const std::function<void(const Particles&)>& look) const;
  std::size_t count() const { return count_of_all(snapshot_.particles); }
  const RunSettings& settings() const { return settings_; }
  const Scheme& scheme() const { return *scheme_; }
  Ledger ledger() const { return scheme_->ledger(); }
  std::vector<double> angular_momentum();
  const Profile& profile() const { return profile_; }

  /// Keeps what the energies of a line of the history tell the drift. Throws RunError where they have run away.
  void note(const Ledger& line);

  /// The state as it can be saved, of several ranks each with its own particles; `state` takes what others want to
  /// keep.
  const Snapshot& save(const std::map<std::string, double>& state);

 private:
  void build_scheme();
  void restore(const std::map<std::string, double>& state);
  void note_start();
  /// Deals the particles to the ranks, as the state of the scheme needs it, and builds the scheme anew on them.
  void deal(const std::map<std::string, double>& state);
  /// The same while it runs: it goes on as from a snapshot.
  void deal_again();
  void step_with_others();
  void search(double dt);
  TimeStep choose_step() const;
  void look_for_contact();
  /// det F of a particle whose density follows from it.
  double jacobian_of(std::size_t index) const;
  /// The id of one whose density has become negative with det F.
  std::optional<std::int64_t> inverted_particle() const;
  /// what(index) from the rank that owns the particle.
  template <class What>
  std::string told_by_owner(std::int64_t particle, const What& what) const;
  std::string describe(std::int64_t particle) const;

  Snapshot snapshot_;
  std::optional<Distribution> distribution_;  ///< over several ranks
  bool clamped_ = false;
  RunSettings settings_;
  Profile profile_;
  std::unique_ptr<Scheme> scheme_;
  double time_ = 0.0;
  std::int64_t steps_ = 0;
  std::int64_t first_step_number_ = 0;
  TimeStep last_;
  double first_step_ = 0.0;
  std::optional<double> contact_time_;
  bool touched_ = false;  ///< what the scheme told of contact before a search in the midst of the last step
  double initial_energy_ = 0.0;
  double largest_energy_ = 0.0;  ///< at play, of the lines so far
  double momentum_scale_ = 0.0;
  std::vector<double> initial_momentum_;
  AngularMomentum angular_momentum_;
  std::vector<double> initial_angular_momentum_;
  double largest_angular_momentum_ = 0.0;  ///< at the start
};

}  // namespace tektite
