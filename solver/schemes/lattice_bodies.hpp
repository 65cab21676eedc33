#pragma once
// The bodies whose reference configuration is a lattice. Their pairs are the same for every particle, so nothing of a
// pair is stored or computed anew.

#include <cmath>
#include <vector>

#include "core/particles.hpp"
#include "neighbours/lattice.hpp"
#include "parallel/for_each_on_lattice.hpp"
#include "passes/lagrangian_sums.hpp"

namespace tektite {

template <class Kernel, int D>
class LatticeBodies {
 public:
  /// Takes the bodies that lie on a lattice and have one smoothing length. `places` and `body_of` are those of all
  /// records in the reference configuration, images behind the particles; `corrected` says whether passes read
  /// corrections.
  void find(const Particles& particles, std::span<const Vector<double, D>> places,
            std::span<const std::uint32_t> body_of, double support, bool corrected) {
    bodies_.clear();
    lists_.assign(particles.count(), 1);
    std::vector<std::vector<std::uint32_t>> members(particles.bodies().size());
    for (std::uint32_t i = 0; i < places.size(); ++i) members[body_of[i]].push_back(i);
    const auto h = particles.reals(Field::smoothing_length);
    for (std::size_t k = 0; k < members.size(); ++k) {
      const auto& body = particles.bodies()[k];
      if (body.range.size() == 0) continue;
      const double first = h[body.range.begin];
      const auto own = h.subspan(body.range.begin, body.range.size());
      if (std::ranges::any_of(own, [first](double other) { return other != first; })) continue;
      auto lattice = Lattice<D>::find(places, members[k], body.spacing, std::min(support, Kernel::support * first));
      if (!lattice) continue;
      std::fill_n(lists_.begin() + static_cast<std::ptrdiff_t>(body.range.begin), body.range.size(), std::uint8_t{0});
      bodies_.emplace_back(std::move(*lattice), first, corrected);
    }
    visit([count = particles.count()](std::size_t i) { return i < count; });
  }

  bool any() const { return !bodies_.empty(); }
  /// One for each particle that needs a list of neighbours, zero for those on a lattice.
  const std::vector<std::uint8_t>& lists() const { return lists_; }

  void fill(const std::vector<ReferenceRecord<D>>& records) {
    for (auto& body : bodies_) body.reference.fill(body.lattice, records);
  }
  void fill(const std::vector<MotionRecord<D>>& records) {
    for (auto& body : bodies_) body.motion.fill(body.lattice, records);
  }
  void fill(const std::vector<StressRecord<D>>& records) {
    for (auto& body : bodies_) body.stress.fill(body.lattice, records);
  }

  /// Leaves out where wanted(record) says no.
  template <class Wanted>
  void visit(const Wanted& wanted) {
    for (auto& body : bodies_) body.lattice.visit(wanted);
  }

  /// Runs make(records) over the first `count` particles' pairs.
  template <class Make>
  void for_each_pair(const Make& make, std::size_t count) const {
    for (const auto& body : bodies_)
      for_each_on_lattice<D, ReferencePair<double, D>>(
          body.lattice, body.pairs,
          make(LatticeRecords<D>{body.reference.view(), body.motion.view(), body.stress.view()}), count);
  }

  std::size_t memory() const {
    std::size_t bytes = lists_.capacity();
    for (const auto& body : bodies_)
      bytes += body.lattice.memory() + body.reference.memory() + body.motion.memory() + body.stress.memory();
    return bytes;
  }

 private:
  /// Of the numbers of a reference record, those that stand before its correction.
  static constexpr std::size_t before_correction =
      (sizeof(ReferenceRecord<D>) - sizeof(Correction<double, D>)) / sizeof(double);

  struct Body {
    Lattice<D> lattice;
    std::vector<ReferencePair<double, D>> pairs;
    TransposedRecords<ReferenceRecord<D>> reference;
    TransposedRecords<MotionRecord<D>> motion;
    TransposedRecords<StressRecord<D>> stress;

    Body(Lattice<D> found, double h, bool corrected)
        : lattice(std::move(found)),
          reference(lattice, corrected ? reference.all : before_correction),
          motion(lattice),
          stress(lattice) {
      for (const auto& neighbour : lattice.neighbours()) {
        const KernelPair<Kernel, D> pair(broadcast(neighbour.x), Pack(h));
        auto slope = Vector<double, D>::zero();
        for (int k = 0; k < D; ++k) slope[k] = pair.slope[k][0];
        pairs.push_back({neighbour.x, h, pair.value[0], slope});
      }
    }
  };

  std::vector<Body> bodies_;
  std::vector<std::uint8_t> lists_;
};

}  // namespace tektite
