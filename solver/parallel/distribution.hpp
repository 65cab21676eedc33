#pragma once
// The particles of a run on several ranks. Each rank has those that it owns and copies of all that are as near to one
// of them as a step reaches, in the order in which a single process has them. So a step gives its own exactly what it
// would with all particles; the copies come out wrong near their rim, and are taken from their owners again.

#include <chrono>
#include <cstdint>
#include <utility>
#include <vector>

#include "core/particles.hpp"
#include "core/scene.hpp"
#include "parallel/halo.hpp"
#include "parallel/packed.hpp"

namespace tektite {

class Distribution {
 public:
  /// Images behind planes of `symmetry` are near, too.
  explicit Distribution(std::vector<SymmetryPlane> symmetry) : symmetry_(std::move(symmetry)) {}

  /// Gives each rank its own particles and copies of those in its halos. The owners change where that is worth it, or
  /// at the first time.
  void deal(Particles& particles, const Halos& halos);
  /// Takes the copies from their owners again.
  void refresh(Particles& particles);
  /// One field of them.
  void refresh(Particles& particles, Field field);
  /// What this rank owns, with copies of those in other halos.
  Particles with_copies(const Particles& particles, const Halos& halos) const;

  /// So many seconds this rank has computed a step: by these costs particles are dealt.
  void note_step(double seconds) { seconds_ += seconds, ++steps_; }

 private:
  using Clock = std::chrono::steady_clock;
  bool worth_it(const Particles& particles);
  std::vector<int> new_owners(const Particles& particles, Field places, const std::vector<std::uint32_t>& own) const;
  /// Who has been sent to each rank, a byte for each of the own particles.
  using Sent = std::vector<std::vector<std::uint8_t>>;
  Sent add_copies_to(Particles& own, const Halos& halos) const;
  void move(Particles& particles, Field places);
  void fetch_copies(Particles& particles, const Halos& halos);
  void refresh(Particles& particles, const PackedLayout& layout);

  std::vector<SymmetryPlane> symmetry_;
  bool dealt_ = false;
  double seconds_ = 0.0;  ///< of the steps since the last call of deal()
  std::int64_t steps_ = 0;
  double cost_ = 1.0;        ///< of one of this rank's particles, s a step
  double fresh_step_ = 0.0;  ///< seconds of a step right after owners have changed, the mean of all ranks
  double lost_ = 0.0;        ///< seconds by which the slowest rank has been slower than that since then
  double moving_ = 0.0;      ///< seconds that a change of owners takes
  std::vector<std::vector<std::uint32_t>> to_, from_;  ///< who is sent to each rank, and who comes from it
};

/// The least and the most particles that a rank owns.
std::pair<std::size_t, std::size_t> least_and_most_owned(const Particles& particles);

}  // namespace tektite
