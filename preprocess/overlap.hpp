#pragma once
// Two bodies cannot be in one place.

#include <span>

#include "preprocess/body.hpp"

namespace tektite::preprocess {

/// Throws InputError, with both names and a place, where a particle of one body lies inside the shape of another, or
/// nearer to one of its particles than half the smaller spacing. Touching bodies and exactly half a spacing are
/// allowed.
void check_overlaps(std::span<const FilledBody> bodies);

}  // namespace tektite::preprocess
