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

/// Appends the ring's particles, beginning at `start_angle` in radians.
void append_ring(std::vector<Point>& positions, const Point& centre, double radius, std::size_t count,
                 double start_angle);

/// The round body that rings need. Throws InputError where the shape is none.
Round expect_round(const Shape& shape, const char* arrangement, const char* allowed);

/// Radii from the inner to the outer edge of a round body, in m.
std::vector<double> radii(const Round& round, double spacing, bool edges_included);

}  // namespace tektite::preprocess
