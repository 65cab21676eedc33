#pragma once
// [body.NAME.region.NAME]: particles of a body that start otherwise than the rest of it. A region is any shape of the
// space; it is not cut to the body, and where two regions share a particle the later one of the scene decides.

#include <optional>
#include <span>
#include <string>
#include <vector>

#include "core/kernel_type.hpp"
#include "core/particles.hpp"
#include "core/scene.hpp"
#include "preprocess/geometry/shape.hpp"
#include "preprocess/velocity/velocity.hpp"

namespace tektite::preprocess {

/// What a region asks of the particles inside; what is empty stays as it was.
struct BodyRegion {
  std::string name;
  ShapePointer shape;
  std::optional<double> density;  ///< initial density in kg/m³; a particle's mass is that of its cell at this density
  std::optional<double> energy;   ///< initial specific internal energy in J/kg
  std::optional<KernelType> kernel;
  std::optional<bool> clamped;  ///< a clamped particle never moves: its velocity is zero whatever else is said of it
  VelocityPointer velocity;     ///< null where the region gives none
  Section section;              ///< for faults that are found later
};

/// Reads the regions of a body in the order of the scene. Throws InputError, also for a region that asks for nothing.
std::vector<BodyRegion> read_regions(Section& body, Space space);

/// Allocates specific_internal_energy, kernel_type and clamped where a region asks for them; elsewhere there is no
/// energy, the kernels are total-Lagrangian and nothing is clamped.
void allocate_region_fields(std::span<const BodyRegion> regions, Particles& particles);

struct RegionReport {
  std::string name;
  std::size_t count = 0;
  std::string words;  ///< what the region asks for
};

/// Lays the regions of a body over density, energy, velocity, kernel_type and clamped of its particles in `range`,
/// whose positions stand already; a particle within `tolerance` (m) of a region's edge is inside. Counted are those of
/// all ranks. Throws InputError for a region that holds no particle.
std::vector<RegionReport> lay_regions(std::span<const BodyRegion> regions, std::span<const SymmetryPlane> planes,
                                      double tolerance, Range range, Particles& particles);

}  // namespace tektite::preprocess
