#pragma once
// Who is near whom in the reference configuration: bodies on a lattice know it without lists, all others have lists.

#include <algorithm>
#include <optional>
#include <vector>

#include "neighbours/reference_pairs.hpp"
#include "parallel/for_each_pair.hpp"
#include "schemes/lattice_bodies.hpp"

namespace tektite {

template <class Kernel, int D>
class ReferenceNeighbours {
 public:
  /// What the lists have to hold beside the particles that are on no lattice.
  enum class Lists { off_lattice, all };

  /// Finds lattices, if `lattices` are wanted, lists, and the images of `mirror`.
  void find(const Particles& particles, Mirror<D>& mirror, double support, bool lattices, Lists lists) {
    count_ = particles.count();
    const ReferencePlaces<D> places(particles, mirror, support);
    if (lattices) {
      const Owned owned(particles);
      std::vector<std::uint8_t> owned_records(count_);
      for (std::size_t i = 0; i < count_; ++i) owned_records[i] = owned(i) ? 1 : 0;
      mirror.repeat(owned_records);
      lattices_.find(particles, places.x, places.body, owned_records, support);
    }
    if (lists == Lists::off_lattice && lattices_.any())
      pairs_ = reference_pairs<D>(places, count_, support, lattices_.lists());
    else
      pairs_ = reference_pairs<D>(places, count_, support);
  }

  /// The lists, of all particles or of those on no lattice.
  const PairList& pairs() const { return pairs_; }

  /// Leaves the particles on lattices without lists.
  void drop_lists_of_lattices() {
    if (lattices_.any()) keep_off_lattice(pairs_);
  }

  /// Leaves without neighbours those of which neither they nor any of their neighbours are `wanted`, by lists and on
  /// lattices; there have to be lists of all particles, and they stay.
  template <class Wanted>
  void keep(const Wanted& wanted) {
    std::vector<std::uint8_t> kept(count_);
    pairs_.keep([&](std::size_t i, std::span<const std::uint32_t> neighbours) {
      return kept[i] = wanted(i) || std::ranges::any_of(neighbours, wanted);
    });
    if (!lattices_.any()) return;
    lattices_.visit([&](std::size_t i) { return i < count_ && kept[i]; });
    off_lattice_ = pairs_;
    keep_off_lattice(*off_lattice_);
  }

  /// Runs make(records), a pass, over all pairs. It may write to none of the `records`: those that it does not read are
  /// left out.
  template <class Make>
  void sweep(const ListedRecords<D>& records, const Make& make) const {
    for_each_pair(off_lattice_ ? *off_lattice_ : pairs_, make(records));
    lattices_.for_each_pair(records, make, count_);
  }

  std::size_t memory() const {
    return pairs_.memory() + (off_lattice_ ? off_lattice_->memory() : 0) + lattices_.memory();
  }

 private:
  void keep_off_lattice(PairList& pairs) const {
    pairs.keep([this](std::size_t i, std::span<const std::uint32_t>) { return lattices_.lists()[i] != 0; });
    pairs.drop_runs(lattices_.lists());
  }

  std::size_t count_ = 0;
  LatticeBodies<Kernel, D> lattices_;
  PairList pairs_;
  std::optional<PairList> off_lattice_;  ///< what sweeps read of `pairs_` where that holds all
};

}  // namespace tektite
