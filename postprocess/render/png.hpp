#pragma once
// A canvas as a PNG file.

#include <string>

#include "postprocess/render/canvas.hpp"

namespace tektite {

/// Writes it beside its place and renames it. Throws RunError.
void write_png(const Canvas& canvas, const std::string& path);

}  // namespace tektite
