#pragma once
// Two bodies cannot be in one place.

#include <span>

#include "preprocess/body.hpp"

namespace tektite::preprocess {

/// Throws InputError, with both names and a place, where a particle of one body lies inside the shape of another, or
/// nearer to one of its particles than half the smaller spacing, or where the shapes reach into each other by more than
/// a tenth of it. Touching bodies and particles exactly half a spacing apart are allowed.
void check_overlaps(std::span<const FilledBody> bodies);

}  // namespace tektite::preprocess
