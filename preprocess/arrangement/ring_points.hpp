#pragma once
// Particles at equal distances on circles, as rings and lattice-with-rings use them.

#include <vector>

#include "core/document.hpp"
#include "preprocess/geometry/shape.hpp"

namespace tektite::preprocess {

/// What to do with 2π r/δ, the number of spacings around a ring.
enum class Rounding { nearest, down };

/// Reads a key that holds "nearest" or "down".
Rounding read_rounding(Section& section, const std::string& key, const std::string& otherwise);

/// Number of particles on a ring whose radius is `radius_in_spacings` δ; 1 where that is zero.
std::size_t ring_count(double radius_in_spacings, Rounding rounding);

/// Reads start_angle, the direction from the centre, counted from x, in which each ring has its first particle.
double read_start_angle(Section& section);

/// A ring of particles, the first of them at `start_angle` in radians.
struct RingOfPoints {
  Point centre{};
  double radius = 0.0;
  std::size_t count = 0;
  double start_angle = 0.0;
};

/// Appends those from ≤ k < to.
void append_ring(std::vector<Point>& positions, const RingOfPoints& ring, std::size_t from, std::size_t to);

/// The round body that rings need. Throws InputError where the shape is none.
Round expect_round(const Shape& shape, const char* arrangement, const char* allowed);

/// Radii from the inner to the outer edge of a round body, in m.
std::vector<double> radii(const Round& round, double spacing, bool edges_included);

}  // namespace tektite::preprocess
