#pragma once
// The shapes by name: one row a shape.

#include "core/document.hpp"
#include "preprocess/geometry/shape.hpp"

namespace tektite::preprocess {

/// Reads `shape = { type = ..., ... }` for a space of `dimensions` coordinates, with the keys `rotate` and `translate`
/// that every shape has. Throws InputError; an unknown type, or one of another space, is answered with those allowed.
ShapePointer read_shape(Section section, int dimensions);

}  // namespace tektite::preprocess
