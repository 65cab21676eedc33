#pragma once
// Points on their way from rank to rank; one process keeps its own.

#include <vector>

#include "preprocess/arrangement/share.hpp"
#include "preprocess/geometry/placement.hpp"

namespace tektite::preprocess {

/// What this rank has of anything that is numbered.
Share this_share();

/// Points in the order of the ranks, and on each rank in its own: each rank gets as many of them as the others, and the
/// order stays.
struct DealtPoints {
  std::vector<Point> points;
  std::size_t first = 0;  ///< how many are on the ranks before
  std::size_t all = 0;    ///< how many there are on all
};
DealtPoints deal(std::vector<Point> own);

/// Of the points of all ranks those that lie within `margin` (m) of a box about `own`, in the order of the ranks.
std::vector<Point> points_about(const std::vector<Point>& own, double margin, const std::vector<Point>& points);

/// How many there are on all ranks of what each counts on its own.
std::size_t on_all_ranks(std::size_t own);

}  // namespace tektite::preprocess
