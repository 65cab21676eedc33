#pragma once
// A field of the particles over a coordinate.

#include <string>

#include "core/snapshot.hpp"
#include "postprocess/render/draw.hpp"

namespace tektite {

/// Draws the picture's field at the particles of its bodies over x, y, z or the distance from its centre, with the
/// exact curve where the picture gives one. Throws RunError where the snapshot does not hold the field.
void draw_profile(const Picture& picture, const Snapshot& snapshot, const Drawing& drawing, const std::string& path);

}  // namespace tektite
