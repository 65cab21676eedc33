#pragma once
// Which points of a row lie inside a closed triangle mesh: one search of the mesh's AABB tree a row, so that the cost
// is that of the rows and not of the points.

#include <memory>

#include "preprocess/geometry/shape.hpp"
#include "preprocess/geometry/surface.hpp"

namespace tektite::preprocess {

class MeshRows {
 public:
  explicit MeshRows(const Surface& surface);
  ~MeshRows();

  /// Marks the points of a row along x (row.step = (s, 0, 0), s > 0) as Shape::mark does. Safe to call from many
  /// threads at once.
  void mark(const Row& row, double tolerance, std::span<std::uint8_t> inside) const;

 private:
  struct Tree;
  std::unique_ptr<Tree> tree_;
};

}  // namespace tektite::preprocess
