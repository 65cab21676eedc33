#pragma once
// The whole stage: a scene becomes the particles at time 0, and a report in words of what they are.

#include <string>
#include <vector>

#include "core/document.hpp"
#include "core/snapshot.hpp"
#include "preprocess/body_region.hpp"

namespace tektite::preprocess {

struct BodyReport {
  std::string name;
  std::string material;
  std::size_t count = 0;
  std::size_t on_symmetry_planes = 0;
  double spacing = 0.0;     ///< m
  double mass = 0.0;        ///< sum over the particles: kg, kg/m in the plane, kg/m² on a line
  double exact_mass = 0.0;  ///< of the shape, likewise; the share of a region of other density is that of its particles
  bool mass_spread = false;
  std::vector<std::string> remarks;
  std::vector<std::string> warnings;
  std::vector<RegionReport> regions;
};

struct Result {
  Snapshot snapshot;               ///< with a share of each body's particles on each of several ranks
  std::vector<Body> whole;         ///< the bodies with the particles of all ranks
  std::vector<std::size_t> first;  ///< the number of each one's first particle here among all
  std::vector<BodyReport> bodies;

  std::size_t count() const { return whole.back().range.end; }  ///< of all ranks
};

inline constexpr double default_most_particles = 2e8;

/// Reads what the preprocessor owns of the scene, fills all bodies and checks that they do not overlap. Afterwards the
/// document is the effective scene. Throws InputError, on all ranks the same.
Result build_particles(Document& document, double most_particles = default_most_particles);

/// The report as lines of text.
std::string in_words(const Result& result);

}  // namespace tektite::preprocess
