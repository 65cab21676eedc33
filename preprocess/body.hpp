#pragma once
// One [body.NAME] of a scene: read, then filled with particles.

#include <map>
#include <span>
#include <string>
#include <vector>

#include "core/scene.hpp"
#include "preprocess/arrangement/registry.hpp"
#include "preprocess/body_region.hpp"
#include "preprocess/geometry/shape.hpp"
#include "preprocess/velocity/velocity.hpp"

namespace tektite::preprocess {

/// What a scene says of a body.
struct BodyPlan {
  std::string name;
  std::string material;
  double density = 0.0;  ///< kg/m³
  double spacing = 0.0;  ///< m; 0 where a count is wished for
  ShapePointer shape;
  ArrangementChoice arrangement;
  VelocityPointer velocity;
  std::vector<BodyRegion> regions;  ///< later ones override earlier ones
  Section section;                  ///< for faults that are found later
};

/// A body with its particles: of several ranks each has as many as the others, one rank's behind the other's.
struct FilledBody {
  BodyPlan plan;
  std::vector<Point> positions;  ///< m
  std::size_t first = 0;         ///< how many the ranks before have
  std::size_t count = 0;         ///< how many there are on all ranks
  double spacing = 0.0;          ///< m
  double step_along_x = 0.0;     ///< m, of the cells: the spacing unless they are stretched
  double cell = 0.0;             ///< m, m² or m³ for each particle
  double exact_measure = 0.0;    ///< m, m² or m³ of the part of the shape on the kept side, about the axis if any
  std::vector<std::string> warnings;
};

/// Densities by material name, in kg/m³, from [material.NAME].
std::map<std::string, double> read_densities(Section& root);

/// Reads all [body.NAME] in the order of the scene, and the scene's `spacing`. Throws InputError.
std::vector<BodyPlan> read_bodies(Section& root, const Scene& scene, const std::map<std::string, double>& densities);

/// Fills a body of a scene, all ranks together; only the side of the symmetry planes that is kept. Throws InputError
/// where that would give more than `most_particles`, where no particle falls inside, or where the body is thinner than
/// a spacing.
FilledBody fill_body(BodyPlan plan, const Scene& scene, double most_particles);

}  // namespace tektite::preprocess
