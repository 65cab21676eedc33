#pragma once
// The arrangements by name, one row each, and what all of them share: the wished count and how mass is given.

#include <cstdint>
#include <optional>

#include "core/document.hpp"
#include "preprocess/arrangement/arrangement.hpp"

namespace tektite::preprocess {

enum class MassRule {
  cell,   ///< every particle has its cell's volume times the density
  exact,  ///< the exact mass of the body is spread evenly over its particles
};

struct ArrangementChoice {
  ArrangementPointer arrangement;
  std::optional<std::int64_t> wished_count;
  MassRule mass = MassRule::cell;
};

/// Reads `arrangement = { type = ..., ... }`; a lattice where `type` is left out. Throws InputError; an unknown type,
/// or one of another space, is answered with those allowed.
ArrangementChoice read_arrangement(Section section, int dimensions);

/// The spacing whose count comes nearest to `wished`: by bisection, since counts grow as the spacing shrinks but for
/// jumps of whole layers.
double spacing_for_count(const Arrangement& arrangement, const Shape& shape, std::size_t wished);

}  // namespace tektite::preprocess
