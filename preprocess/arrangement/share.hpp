#pragma once
// Several processes fill a body together, each with its share of the places in the order of all.

#include <algorithm>
#include <cstddef>
#include <numeric>
#include <span>

#include "core/particles.hpp"

namespace tektite::preprocess {

/// One of `parts` that follow each other and are as large as each other; all there is where there is one.
struct Share {
  std::size_t part = 0;
  std::size_t parts = 1;

  Range of(std::size_t count) const { return {begin(count, part), begin(count, part + 1)}; }

 private:
  std::size_t begin(std::size_t count, std::size_t at) const {
    return count / parts * at + count % parts * at / parts;  // no product that could be too large
  }
};

/// Of groups of these sizes, such as rings, what the share has: append(group, from, to) for the members from ≤ k < to.
template <class Append>
void for_share(const Share& share, std::span<const std::size_t> sizes, const Append& append) {
  const auto mine = share.of(std::accumulate(sizes.begin(), sizes.end(), std::size_t{0}));
  std::size_t before = 0;
  for (std::size_t group = 0; group < sizes.size(); before += sizes[group++]) {
    const auto place = [&](std::size_t k) { return std::clamp(k, before, before + sizes[group]) - before; };
    if (place(mine.begin) < place(mine.end)) append(group, place(mine.begin), place(mine.end));
  }
}

}  // namespace tektite::preprocess
