#pragma once
// Triangle meshes from files: read, checked, and repaired where that is safe.

#include <string>
#include <vector>

#include "preprocess/geometry/surface.hpp"

namespace tektite::preprocess {

struct MeshFile {
  Surface surface;
  std::vector<std::string> repairs;  ///< what was repaired, in words
};

/// Reads a closed surface from STL (ascii or binary), OFF, OBJ or PLY; coordinates are multiplied by `metres`.
/// Repaired and said: doubled points, degenerate and doubled faces, points that no face uses, faces that look inward,
/// polygons with more than three corners. Throws InputError that names `path` where the file is missing or unreadable,
/// holds nothing, or its surface is open, not manifold or intersects itself, each with a place.
MeshFile read_mesh_file(const std::string& path, double metres);

}  // namespace tektite::preprocess
