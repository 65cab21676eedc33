#pragma once
// The bodies whose reference configuration is a lattice. Their pairs are the same for every particle, so nothing of a
// pair is stored or computed anew.

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

#include "core/particles.hpp"
#include "neighbours/lattice.hpp"
#include "parallel/for_each_on_lattice.hpp"
#include "parallel/ranks.hpp"
#include "passes/lagrangian_sums.hpp"

namespace tektite {

/// What the passes read beside the records that all read.
struct LagrangianReads {
  bool corrected;             ///< the records of shifts
  bool hourglass;             ///< the records of the control of zero-energy modes
  bool strain_rates = false;  ///< the records of a viscosity that reconstructs velocities
};

template <class Kernel, int D>
class LatticeBodies {
 public:
  /// Takes the bodies that lie on a lattice, on all ranks, and have one smoothing length. `places`, `body_of` and
  /// `owned` are those of all records in the reference configuration, images behind the particles; `read` says what
  /// passes read.
  void find(const Particles& particles, std::span<const Vector<double, D>> places,
            std::span<const std::uint32_t> body_of, std::span<const std::uint8_t> owned, double support,
            LagrangianReads read) {
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
      bodies_.emplace_back(std::move(*lattice), h, read);
    }
    visit([count = particles.count()](std::size_t i) { return i < count; });
  }

  bool any() const { return !bodies_.empty(); }
  /// One for each particle that needs a list of neighbours, zero for those on a lattice.
  const std::vector<std::uint8_t>& lists() const { return lists_; }

  void fill(const std::vector<ReferenceRecord<D>>& records) {
    for (auto& body : bodies_) body.rows.fill(body.lattice, records, 0, of_reference);
  }
  void fill(const std::vector<MotionRecord<D>>& records) {
    for (auto& body : bodies_) body.rows.fill(body.lattice, records, of_reference, of_motion);
  }
  void fill(const std::vector<StressRecord<D>>& records) {
    for (auto& body : bodies_) body.rows.fill(body.lattice, records, before_stress, of_stress);
  }
  void fill(const std::vector<ShiftRecord<D>>& records) {
    for (auto& body : bodies_) body.rows.fill(body.lattice, records, before_shift, of_shift);
  }
  void fill(const std::vector<HourglassRecord<D>>& records) {
    for (auto& body : bodies_) body.rows.fill(body.lattice, records, body.before_hourglass(), of_hourglass);
  }

  void fill(const std::vector<StrainRateRecord<D>>& records) {
    for (auto& body : bodies_) body.rows.fill(body.lattice, records, body.before_strain_rate(), of_strain_rate);
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
      for_each_on_lattice<D, TransposedRecords, ReferencePair<double, D>>(
          body.lattice, body.rows, body.pairs,
          make(LatticeRecords<D>{body.rows.template view<ReferenceRecord<D>>(0),
                                 body.rows.template view<MotionRecord<D>>(of_reference),
                                 body.rows.template view<StressRecord<D>>(before_stress), body.shift(),
                                 body.hourglass(), body.strain_rate()}),
          count);
  }

  std::size_t memory() const {
    std::size_t bytes = lists_.capacity();
    for (const auto& body : bodies_) bytes += body.lattice.memory() + body.rows.memory();
    return bytes;
  }

 private:
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

  // What the rows hold of each record, from its first number on: of the reference record the volume alone, since pairs
  // know the rest; of the stress record all but J. Shifts, and behind them what hourglass control and the viscosity
  // read, are there where passes read them.
  static constexpr std::size_t of_reference = 1;
  static constexpr std::size_t of_motion = sizeof(MotionRecord<D>) / sizeof(double);
  static constexpr std::size_t before_stress = of_reference + of_motion;
  static constexpr std::size_t of_stress = sizeof(StressRecord<D>) / sizeof(double) - 1;
  static constexpr std::size_t before_shift = before_stress + of_stress;
  static constexpr std::size_t of_shift = sizeof(ShiftRecord<D>) / sizeof(double);
  static constexpr std::size_t of_hourglass = sizeof(HourglassRecord<D>) / sizeof(double);
  static constexpr std::size_t of_strain_rate = sizeof(StrainRateRecord<D>) / sizeof(double);

  struct Body {
    Lattice<D> lattice;
    LagrangianReads read;
    TransposedRecords rows;
    std::vector<LatticePair<ReferencePair<double, D>>> pairs;

    Body(Lattice<D> found, double h, LagrangianReads reads)
        : lattice(std::move(found)),
          read(reads),
          rows(lattice, before_strain_rate() + (read.strain_rates ? of_strain_rate : 0)) {
      rows.template empty<StressRecord<D>>(before_stress, of_stress);
      for (const auto& neighbour : lattice.neighbours()) {
        const KernelPair<Kernel, D> pair(broadcast(neighbour.x), Pack(h));
        auto slope = Vector<double, D>::zero();
        for (int k = 0; k < D; ++k) slope[k] = pair.slope[k][0];
        pairs.push_back({{neighbour.x, h, pair.value[0], slope}, rows.way(neighbour.rows, neighbour.columns)});
      }
    }

    std::size_t before_hourglass() const { return before_shift + (read.corrected ? of_shift : 0); }
    std::size_t before_strain_rate() const { return before_hourglass() + (read.hourglass ? of_hourglass : 0); }

    Transposed<ShiftRecord<D>> shift() const {
      if (!read.corrected) return {nullptr, 0};
      return rows.template view<ShiftRecord<D>>(before_shift);
    }
    Transposed<HourglassRecord<D>> hourglass() const {
      if (!read.hourglass) return {nullptr, 0};
      return rows.template view<HourglassRecord<D>>(before_hourglass());
    }
    Transposed<StrainRateRecord<D>> strain_rate() const {
      if (!read.strain_rates) return {nullptr, 0};
      return rows.template view<StrainRateRecord<D>>(before_strain_rate());
    }
  };

  std::vector<Body> bodies_;
  std::vector<std::uint8_t> lists_;
};

}  // namespace tektite
