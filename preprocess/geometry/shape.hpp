#pragma once
// What every shape answers: is a point inside, which points of a row are inside, how far it reaches, and how large it
// is. A shape is a closed set: its edge belongs to it, within a tolerance that the caller gives, because an edge such
// as 501 spacings of 0.01 cm is not exact in binary.

#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "preprocess/geometry/placement.hpp"
#include "preprocess/geometry/region.hpp"
#include "preprocess/geometry/surface.hpp"

namespace tektite::preprocess {

/// Points at equal distances on a straight line: start + k step, k = 0 .. count - 1.
struct Row {
  Point start{};
  Point step{};
  std::size_t count = 0;

  Point at(std::size_t k) const { return start + static_cast<double>(k) * step; }
};

/// What rings and shells need to know: a disc or ball, or what lies between two radii about one centre.
struct Round {
  Point centre{};
  double inner = 0.0;  ///< 0 where there is no hole
  double outer = 0.0;
};

class Shape {
 public:
  virtual ~Shape() = default;

  /// 1, 2 or 3.
  virtual int dimensions() const = 0;

  /// Whether x lies in the shape grown by `tolerance` (m; negative: shrunk). Exact in sign at flat and round faces;
  /// within a few tolerances of an outer corner the grown shape has the corner sharp.
  virtual bool inside(const Point& x, double tolerance) const = 0;

  /// Sets inside[k] to 1 where row.at(k) is inside, otherwise to 0. Meshes answer a row with one cast ray.
  virtual void mark(const Row& row, double tolerance, std::span<std::uint8_t> inside) const;

  /// The largest x·direction over the shape (of an intersection: an upper bound), for a direction of length 1.
  virtual double reach(const Point& direction) const = 0;

  /// The point that arrangements take as origin where the scene gives none.
  virtual Point centre() const;

  /// Length in m, area in m² or volume in m³. Primitives: a formula. Booleans in the plane: exact, by CGAL. Booleans of
  /// solids: of their triangulations (surface.hpp says how fine).
  virtual double measure() const = 0;

  virtual std::optional<Round> round() const { return std::nullopt; }

  /// The shape, moved, as an exact region (two dimensions) or as a closed surface (three).
  virtual Region region(const Placement& placement) const;
  virtual Surface surface(const Placement& placement) const;

  /// Moves the shape itself where that is better than moving every question to it; false where it cannot.
  virtual bool move(const Placement&) { return false; }

  /// What was repaired when the shape was read, in words; empty where nothing was.
  virtual std::vector<std::string> remarks() const { return {}; }

  Box bounds() const;
};

using ShapePointer = std::unique_ptr<Shape>;

/// Moves a shape.
ShapePointer placed(ShapePointer shape, const Placement& placement);

}  // namespace tektite::preprocess
