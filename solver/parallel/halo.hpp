#pragma once

#include <vector>

#include "core/fields.hpp"

namespace tektite {

/// The particles of other ranks that are nearer than `width` in m to one of this rank, by these places. A scheme may
/// need several, one after the other: the first one's places are those by which particles are dealt.
struct Halo {
  double width = 0.0;
  Field places = Field::position;
  bool of_copies = false;  ///< also those near to what the halos before this one have brought
};
using Halos = std::vector<Halo>;

}  // namespace tektite
