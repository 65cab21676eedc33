#pragma once
// What a projectile strikes, as measures of it see it: along the flight line and around it. The target's surface is
// taken to lie across the flight line (normal impact).

#include "postprocess/measure/flight.hpp"

namespace tektite {

struct Target {
  std::int32_t body;
  std::int32_t projectile;
  Point centre;             ///< a point of the flight line: the projectile's centre of mass at the start
  Point direction;          ///< of flight; or the axis that is given, through the place where the projectile strikes
  double spacing;           ///< of the target, in m
  double smoothing_length;  ///< of the target in the end, the largest, in m
  Extent thickness;         ///< of the target at the start, along the direction
  Point carried;            ///< what the target's own velocity at the start makes of the way until the end

  Point across(const Point& x) const {
    const auto apart = x - centre;
    return apart - dot(apart, direction) * direction;
  }
  /// A place of the last state as who flies along with the undisturbed target sees it, and back.
  Point seen(const Point& x) const { return x - carried; }
  Point unseen(const Point& x) const { return x + carried; }
  /// The point of the flight line that lies `along` far in the direction.
  Point on_line(double along) const { return centre + (along - dot(centre, direction)) * direction; }
};

/// Finds the target of an event.
using FindTarget = std::function<Target(const Event&)>;

/// The keys body (the target), projectile (left out: the body that moves fastest against it) and axis. In a line there
/// is nothing across, which is a fault where `needs_across`.
FindTarget read_target(Section& section, const Declared& declared, bool needs_across);

enum class Face { front, back };

/// Throws RunError where a face of the target at the start does not lie across the flight line: where its farthest
/// matter, that within a spacing, does not surround the line.
void require_across(const Event& event, const Target& target, Face face);

/// What on_rim() looks at of the last snapshot.
inline const FieldSet rim_fields{Field::clamped};

/// For each particle of the last state, whether it belongs to the rim that holds the target: its clamped particles, or
/// where it has none, those that lay in the outermost tenth around the flight line.
std::vector<bool> on_rim(const Event& event, const Target& target);

/// For each fragment, whether it holds a particle of the rim: these are the coherent target.
std::vector<bool> hangs_on_rim(const Event& event, const Fragments& fragments, const std::vector<bool>& rim);

/// A unit vector across a direction of flight, in the plane of a plane scene.
Point side_of(const Point& direction);

/// In which direction around the flight line a place lies: two sides in the plane, twelve sectors in space.
class Sectors {
 public:
  Sectors(const Point& direction, int dimensions);

  std::size_t count() const { return count_; }
  /// Unit vectors that span what is across; in the plane only the first one lies in it.
  const Point& first() const { return first_; }
  const Point& second() const { return second_; }
  std::size_t of(const Point& across) const;

 private:
  Point first_, second_;
  std::size_t count_;
};

}  // namespace tektite
