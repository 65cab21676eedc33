#pragma once
// Columns of the history over time.

#include <string>

#include "core/scene.hpp"
#include "postprocess/history.hpp"
#include "postprocess/render/picture.hpp"

namespace tektite {

/// Draws the picture's columns, which must have one unit, as lines over time. Throws RunError.
void draw_history(const Picture& picture, const History& history, const Scene& scene, const std::string& path);

/// SI unit of a column of history.csv: that of the field for a probe (NAME.FIELD), else by the kind of quantity. Energy
/// and momentum of a plane scene are those of a slice one metre thick.
std::string unit_of_column(const std::string& column);

}  // namespace tektite
