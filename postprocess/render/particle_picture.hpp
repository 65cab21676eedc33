#pragma once
// A field of the particles at one time, as a PNG file.

#include <string>

#include "postprocess/render/draw.hpp"

namespace tektite {

/// Throws RunError where the snapshot does not hold the field or the file cannot be written.
void draw_particles(const Picture& picture, const Snapshot& snapshot, const Drawing& drawing, const std::string& path);

}  // namespace tektite
