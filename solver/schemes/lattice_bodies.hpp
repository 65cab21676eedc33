#pragma once
// The bodies whose reference configuration is a lattice. Their pairs are the same for every particle, so nothing of a
// pair is stored or computed anew; records are copied for the few planes that are being swept (passes/transposed.hpp).

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

#include "core/particles.hpp"
#include "neighbours/lattice.hpp"
#include "parallel/for_each_on_lattice.hpp"
#include "parallel/ranks.hpp"
#include "passes/copied_records.hpp"
#include "passes/lagrangian_sums.hpp"

namespace tektite {

template <class Kernel, int D>
class LatticeBodies {
 public:
  /// Takes the bodies that lie on a lattice, on all ranks, and have one smoothing length. `places`, `body_of` and
  /// `owned` are those of all records in the reference configuration, images behind the particles.
  void find(const Particles& particles, std::span<const Vector<double, D>> places,
            std::span<const std::uint32_t> body_of, std::span<const std::uint8_t> owned, double support) {
    bodies_.clear();
    lists_.assign(particles.count(), 1);
    std::vector<std::vector<std::uint32_t>> members(particles.bodies().size());
    for (std::uint32_t i = 0; i < places.size(); ++i) members[body_of[i]].push_back(i);
    for (std::size_t k = 0; k < members.size(); ++k) {
      const auto& body = particles.bodies()[k];
      const auto first = first_of(particles, body.range, places);
      auto frame = Lattice<D>::frame_of(places, members[k], first.place, body.spacing);
      frame.count = static_cast<std::size_t>(std::ranges::count_if(members[k], [&](auto i) { return owned[i] != 0; }));
      frame.sound = frame.sound && first.least_smoothing == first.most_smoothing;
      frame = over_ranks(particles, frame, Lattice<D>::Frame::join);
      const double h = first.least_smoothing;
      auto lattice = Lattice<D>::find(places, members[k], std::min(support, Kernel::support * h), frame);
      const auto both = [](bool& whole, bool part) { whole = whole && part; };
      if (!over_ranks(particles, lattice.has_value(), both) || members[k].empty()) continue;
      std::fill_n(lists_.begin() + static_cast<std::ptrdiff_t>(body.range.begin), body.range.size(), std::uint8_t{0});
      bodies_.emplace_back(std::move(*lattice), h);
    }
    visit([count = particles.count()](std::size_t i) { return i < count; });
  }

  bool any() const { return !bodies_.empty(); }
  /// One for each particle that needs a list of neighbours, zero for those on a lattice.
  const std::vector<std::uint8_t>& lists() const { return lists_; }

  /// Leaves out where wanted(record) says no.
  template <class Wanted>
  void visit(const Wanted& wanted) {
    for (auto& body : bodies_) body.lattice.visit(wanted);
  }

  /// Runs make(records) over the first `count` particles' pairs; it reads copies of those `records` that there are, and
  /// may write to none of them.
  template <class Make>
  void for_each_pair(const ListedRecords<D>& records, const Make& make, std::size_t count) const {
    for (const auto& body : bodies_) {
      const auto work = [&](std::size_t first, std::size_t end, Window& window) {
        sweep(body, records, make, count, first, end, window);
      };
      for_each_on_lattice(body.lattice, windows_, work);
    }
  }

  std::size_t memory() const {
    std::size_t bytes = lists_.capacity();
    for (const auto& body : bodies_) bytes += body.lattice.memory();
    for (const auto& window : windows_) bytes += window.records.memory();
    return bytes;
  }

 private:
  struct Body {
    Lattice<D> lattice;
    std::vector<ReferencePair<double, D>> pairs;

    Body(Lattice<D> found, double h) : lattice(std::move(found)) {
      for (const auto& neighbour : lattice.neighbours()) {
        const KernelPair<Kernel, D> pair(broadcast(neighbour.x), Pack(h));
        auto slope = Vector<double, D>::zero();
        for (int k = 0; k < D; ++k) slope[k] = pair.slope[k][0];
        pairs.push_back({neighbour.x, h, pair.value[0], slope});
      }
    }
  };

  /// What a thread works in.
  struct Window {
    TransposedWindow records;
    std::vector<std::ptrdiff_t> ways;
  };

  /// Some layers of a body, on one thread.
  template <class Make>
  static void sweep(const Body& body, const ListedRecords<D>& records, const Make& make, std::size_t count,
                    std::size_t first, std::size_t end, Window& window) {
    auto& copies = window.records;
    const CopiedRecords<D> copied(records);
    copies.prepare(body.lattice, copied.numbers());
    const auto pass = make(copied.views(copies));
    for (auto k = first; k < end; ++k) {
      const auto& layer = body.lattice.layers()[k];
      copies.move_to(body.lattice, layer,
                     [&](std::span<const std::uint32_t> cells, double* to) { copied.copy(copies, cells, to); });
      copies.find_ways(layer.plane, body.lattice.neighbours(), window.ways);
      gather_packs(body.lattice, layer, body.lattice.packs_of(k), copies, std::span(body.pairs),
                   std::span<const std::ptrdiff_t>(window.ways), pass, count);
    }
  }

  /// Of a body on all ranks: the place of the particle of the least id, and the range of h.
  struct First {
    std::int64_t id = std::numeric_limits<std::int64_t>::max();
    Vector<double, D> place = Vector<double, D>::zero();
    double least_smoothing = std::numeric_limits<double>::infinity(), most_smoothing = 0.0;

    static void join(First& whole, const First& part) {
      if (part.id < whole.id) {
        whole.id = part.id;
        whole.place = part.place;
      }
      whole.least_smoothing = std::min(whole.least_smoothing, part.least_smoothing);
      whole.most_smoothing = std::max(whole.most_smoothing, part.most_smoothing);
    }
  };
  static First first_of(const Particles& particles, const Range& range, std::span<const Vector<double, D>> places) {
    const auto id = particles.integers(Field::id);
    const auto h = particles.reals(Field::smoothing_length);
    First first;
    for (std::size_t i = range.begin; i < range.end; ++i) First::join(first, {id[i], places[i], h[i], h[i]});
    return over_ranks(particles, first, First::join);
  }

  std::vector<Body> bodies_;
  std::vector<std::uint8_t> lists_;
  mutable std::vector<Window> windows_;  ///< one for every thread, empty between sweeps
};

}  // namespace tektite
