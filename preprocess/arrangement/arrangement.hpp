#pragma once
// How a body is filled with particles. An arrangement answers where they sit for a given spacing.
//
// Edges and tolerance: a particle whose place is on the edge of a shape belongs to it. Places and edges are rounded
// numbers (501 spacings of 0.01 cm are not 5.01 cm in binary; a lattice point at distance 6 mm from the centre may come
// out as 6.000000000000001 mm), so every comparison in this room allows `edge_tolerance` spacings. That is a million
// times more than the rounding of coordinates up to a thousand spacings from the origin, and far below anything that
// matters.

#include <cstddef>
#include <memory>
#include <optional>
#include <vector>

#include "core/document.hpp"
#include "preprocess/arrangement/share.hpp"
#include "preprocess/geometry/shape.hpp"

namespace tektite::preprocess {

inline constexpr double edge_tolerance = 1e-9;

/// Bodies do not reach further from the origin, in spacings: coordinates there are rounded to 1e-7 spacings.
inline constexpr double most_spacings = 1e9;

/// The places of a body's particles, and the length, area or volume (m, m², m³) of the cell that each stands for.
struct Filling {
  std::vector<Point> positions;
  double cell = 0.0;
  std::optional<double> step_along_x =
      std::nullopt;  ///< m, of cells that are stretched; nothing where it is the spacing
};

class Arrangement {
 public:
  virtual ~Arrangement() = default;

  /// Fills a share of the shape; the particles of all shares, one behind the other, are those of the whole. Their order
  /// does not depend on the number of threads. Throws InputError where the arrangement does not suit the shape.
  virtual Filling fill(const Shape& shape, double spacing, const Share& share) const = 0;

  /// Number of particles that fill() would give, without their memory where that can be had.
  virtual std::size_t count(const Shape& shape, double spacing) const {
    return fill(shape, spacing, {}).positions.size();
  }

  /// The cell in units of δ^dimensions: 1 but for arrangements that are denser than a lattice.
  virtual double cell_factor() const { return 1.0; }
};

using ArrangementPointer = std::unique_ptr<Arrangement>;

/// floor and ceil of a number of spacings, where whole numbers are whole within the tolerance; and the nearest whole
/// number. Throw InputError where there are more spacings than places can be told apart.
long long floor_within(double spacings);
long long ceil_within(double spacings);
long long nearest_whole(double spacings);

}  // namespace tektite::preprocess
