#pragma once
// The readers of all shapes, each defined in the file of its name. A reader takes its own keys from the section; the
// keys `type`, `rotate` and `translate` are the registry's.

#include "core/document.hpp"
#include "preprocess/geometry/shape.hpp"

namespace tektite::preprocess {

ShapePointer read_segment(Section& section, int dimensions);
ShapePointer read_rectangle(Section& section, int dimensions);
ShapePointer read_disc(Section& section, int dimensions);
ShapePointer read_ring(Section& section, int dimensions);
ShapePointer read_polygon(Section& section, int dimensions);
ShapePointer read_box(Section& section, int dimensions);
ShapePointer read_sphere(Section& section, int dimensions);
ShapePointer read_cylinder(Section& section, int dimensions);
ShapePointer read_ogive(Section& section, int dimensions);
ShapePointer read_revolved(Section& section, int dimensions);
ShapePointer read_extruded(Section& section, int dimensions);
ShapePointer read_mesh(Section& section, int dimensions);
ShapePointer read_union(Section& section, int dimensions);
ShapePointer read_difference(Section& section, int dimensions);
ShapePointer read_intersection(Section& section, int dimensions);

}  // namespace tektite::preprocess
