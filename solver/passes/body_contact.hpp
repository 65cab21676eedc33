#pragma once

#include <algorithm>
#include <vector>

#include "core/particles.hpp"
#include "neighbours/pair_list.hpp"
#include "parallel/reduce.hpp"

namespace tektite {

/// Whether the supports of two particles of different bodies overlap so that they act on each other: r < support · h̄.
template <class Record>
bool body_contact(const PairList& list, const Particles& particles, const std::vector<Record>& records,
                  double support) {
  const auto& bodies = particles.bodies();
  if (bodies.size() < 2) return false;
  const std::size_t count = particles.count();
  const auto touches = [&](bool& found, std::size_t b) {
    const auto& block = list.blocks()[b];
    for (std::size_t k = 0; k + 1 < block.first.size() && !found; ++k) {
      const std::size_t i = block.begin + k;
      const auto own = std::find_if(bodies.begin(), bodies.end(), [&](const Body& body) { return i < body.range.end; });
      for (std::size_t n = block.first[k]; n < block.first[k + 1] && !found; ++n) {
        const std::size_t j = block.neighbours[n];
        if (j >= count || (j >= own->range.begin && j < own->range.end)) continue;
        const double reach = 0.5 * support * (records[i].smoothing_length + records[j].smoothing_length);
        const auto x = records[i].x - records[j].x;
        found = dot(x, x) < reach * reach;
      }
    }
  };
  return over_ranks(particles, reduce(list.blocks().size(), false, touches, either), either);
}

}  // namespace tektite
