#pragma once
// The loop over pairs, in gather form: particle i collects from its neighbours in the order of its list, several at
// once.

#include <cstddef>

#include "core/pack.hpp"
#include "neighbours/pair_list.hpp"
#include "parallel/for_each.hpp"

namespace tektite {

/// All particles of a block. Flattened: the sums then stay in registers from the first neighbour to the last.
template <class Pass>
[[gnu::flatten]] void gather_block(const PairList::Block& block, const Pass& pass) {
  for (std::size_t k = 0; k + 1 < block.first.size(); ++k) {
    const std::size_t i = block.begin + k;
    const auto self = pass.begin(i);
    typename Pass::Sums sums;
    for (std::size_t n = block.first[k]; n < block.first[k + 1]; n += pack_width) {
      const auto* const j = block.neighbours.data() + n;
      if constexpr (requires { pass.far(self, j); })
        if (pass.far(self, j)) continue;
      pass.add(self, j, sums);
    }
    pass.end(i, sums);
  }
}

/// For every particle: pass.begin(i) gives what it is and its empty sums, pass.add(self, j, sums) takes pack_width
/// neighbours, pass.end(i, sums) writes. Packs of which pass.far(self, j) says yes, where a pass has that, are left
/// out. The last pack of a list is filled up with i itself, which is at distance zero and so adds nothing to any sum
/// over gradients.
template <class Pass>
void for_each_pair(const PairList& list, const Pass& pass) {
  for_each_uneven(list.blocks().size(), [&](std::size_t b) { gather_block(list.blocks()[b], pass); });
}

}  // namespace tektite
