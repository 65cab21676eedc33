#pragma once
// Columns of the history over time.

#include <string>

#include "core/scene.hpp"
#include "postprocess/history.hpp"
#include "postprocess/render/picture.hpp"

namespace tektite {

/// Draws the picture's columns, which must have one unit, as lines over time. Throws RunError.
void draw_history(const Picture& picture, const History& history, const Scene& scene, const std::string& path);

/// SI unit of a column of history.csv: that of the field for a probe (NAME.FIELD), else by the kind of quantity.
std::string unit_of_column(const std::string& column);

/// What stands behind the unit of energy and momentum: those of a plane are of a slice one metre thick. Empty
/// elsewhere, and for what has another unit.
std::string slice_of(const std::string& si_unit, Space space);

}  // namespace tektite
