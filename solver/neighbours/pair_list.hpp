#pragma once
// Who is near whom. First stand those within the support, then those of the skin, who make whole packs of which a sum
// sees at once that none is near; both in the order of the cells and, within a cell, of their indices. So the list
// follows from the positions alone; it is filled up with the particle itself to a whole number of packs.

#include <algorithm>
#include <cstdint>
#include <span>
#include <vector>

#include "core/pack.hpp"
#include "core/tensor.hpp"
#include "neighbours/cell_grid.hpp"
#include "parallel/for_each.hpp"

namespace tektite {

/// Which particles are paired.
enum class Pairing { all, within_bodies, across_bodies };

/// How far neighbours are, m: within the support, and with a skin.
struct Reach {
  double support, all;

  Reach(double support_and_all) : Reach(support_and_all, support_and_all) {}
  Reach(double within_support, double with_skin) : support(within_support), all(with_skin) {}
};

class PairList {
 public:
  /// A run of particles that one thread takes at a time.
  struct Block {
    std::size_t begin = 0;
    std::vector<std::uint32_t> first;  ///< where each particle's neighbours begin; one more entry than particles
    std::vector<std::uint32_t> neighbours;
  };

  /// Lists, for the first `count` of the positions, the others within `reach` that they are paired with; the rest are
  /// images. `body` says whose each position is; those of which `listed` says zero get an empty list, none where it
  /// is empty.
  template <int D>
  void build(const CellGrid<D>& grid, std::span<const Vector<double, D>> positions, std::size_t count,
             const Reach& reach, Pairing pairing, std::span<const std::uint32_t> body,
             std::span<const std::uint8_t> listed = {});

  /// Empties the list of every particle i of which wanted(i, neighbours) says no.
  template <class Wanted>
  void keep(const Wanted& wanted) {
    for_each(blocks_.size(), [&](std::size_t b) {
      auto& block = blocks_[b];
      std::uint32_t end = 0;
      for (std::size_t k = 0; k + 1 < block.first.size(); ++k) {
        const std::span list(block.neighbours.data() + block.first[k], block.neighbours.data() + block.first[k + 1]);
        block.first[k] = end;
        if (!wanted(block.begin + k, std::span<const std::uint32_t>(list))) continue;
        std::copy(list.begin(), list.end(), block.neighbours.begin() + end);
        end += static_cast<std::uint32_t>(list.size());
      }
      block.first.back() = end;
      block.neighbours.resize(end);
    });
  }

  /// Keeps of each list the neighbours j of which wanted(i, j) says yes, filled up again to whole packs.
  template <class Wanted>
  void keep_pairs(const Wanted& wanted) {
    for_each(blocks_.size(), [&](std::size_t b) {
      auto& block = blocks_[b];
      std::uint32_t end = 0;
      for (std::size_t k = 0; k + 1 < block.first.size(); ++k) {
        const auto i = static_cast<std::uint32_t>(block.begin + k);
        const auto begin = block.first[k], last = block.first[k + 1];
        block.first[k] = end;
        for (auto n = begin; n < last; ++n)
          if (const auto j = block.neighbours[n]; j != i && wanted(i, j)) block.neighbours[end++] = j;
        while (end % pack_width != 0) block.neighbours[end++] = i;
      }
      block.first.back() = end;
      block.neighbours.resize(end);
    });
  }

  /// Drops the runs of which no particle is wanted: a loop over pairs then does not come to them at all.
  void drop_runs(std::span<const std::uint8_t> wanted) {
    std::erase_if(blocks_, [wanted](const Block& block) {
      const auto run = wanted.subspan(block.begin, block.first.size() - 1);
      return std::ranges::none_of(run, [](auto one) { return one != 0; });
    });
  }

  /// The same where no particle has a neighbour.
  void drop_empty_runs() {
    std::erase_if(blocks_, [](const Block& block) { return block.neighbours.empty(); });
  }

  /// Who has neighbours or is one, in ascending order: whose records a loop over pairs reads. source_of(j) gives the
  /// particle of a neighbour j, which may be an image.
  template <class Source>
  std::vector<std::uint32_t> members(std::size_t count, const Source& source_of) const {
    std::vector<std::uint8_t> read(count, 0);
    for (const auto& block : blocks_)
      for (std::size_t k = 0; k + 1 < block.first.size(); ++k) {
        if (block.first[k] == block.first[k + 1]) continue;
        read[block.begin + k] = 1;
        for (auto n = block.first[k]; n < block.first[k + 1]; ++n) read[source_of(block.neighbours[n])] = 1;
      }
    std::vector<std::uint32_t> members;
    for (std::uint32_t i = 0; i < count; ++i)
      if (read[i] != 0) members.push_back(i);
    return members;
  }

  const std::vector<Block>& blocks() const { return blocks_; }
  std::size_t memory() const;

 private:
  std::vector<Block> blocks_;
};

/// Those of ascending `members` that a range holds.
inline std::span<const std::uint32_t> members_in(const Range& range, std::span<const std::uint32_t> members) {
  const auto begin = std::ranges::lower_bound(members, range.begin), end = std::ranges::lower_bound(members, range.end);
  return {begin, end};
}

}  // namespace tektite
