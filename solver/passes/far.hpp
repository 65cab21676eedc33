#pragma once

#include <cstdint>

#include "passes/gathered.hpp"
#include "passes/kernel_pair.hpp"
#include "passes/smoothing.hpp"

namespace tektite {

/// Whether no neighbour in j is within the support of a particle `a` that knows its place x and its h, but those in its
/// own place. Lists end with packs that hold the skin alone.
template <class Kernel, class Self, class Record, class Smoothing>
[[gnu::always_inline]] inline bool all_far(const Self& a, const Record* records, const std::uint32_t* j,
                                           const Smoothing& smoothing) {
  return beyond_support<Kernel>(a.x - gathered(records, j, &Record::x),
                                smoothing.of_pair(a.h, gathered(records, j, &Record::smoothing_length)));
}

}  // namespace tektite
