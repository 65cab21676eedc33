#include "preprocess/build_particles.hpp"

#include <numbers>
#include <numeric>

#include "preprocess/body.hpp"
#include "preprocess/overlap.hpp"
#include "preprocess/symmetry.hpp"

namespace tektite::preprocess {
namespace {

std::vector<Body> ranges(const std::vector<FilledBody>& filled) {
  std::vector<Body> bodies;
  std::size_t first = 0;
  for (const auto& body : filled) {
    bodies.push_back({body.plan.name, body.plan.material, body.spacing, {first, first + body.positions.size()}});
    first += body.positions.size();
  }
  return bodies;
}

/// Number of whole particles: one on a symmetry plane is half a particle.
double whole_particles(const FilledBody& body, std::span<const SymmetryPlane> planes) {
  double shares = 0.0;
  for (const auto& position : body.positions) shares += mass_share(position, planes);
  return shares;
}

/// Volume (m, m² or m³) of a particle that lies off all symmetry planes.
double whole_volume(const FilledBody& body, std::span<const SymmetryPlane> planes) {
  if (body.plan.arrangement.mass == MassRule::cell) return body.cell;
  return body.exact_measure / whole_particles(body, planes);
}

void store(const FilledBody& body, const Scene& scene, Range range, Particles& particles) {
  const auto d = static_cast<std::size_t>(particles.dimensions());
  auto positions = particles.reals(Field::position), velocities = particles.reals(Field::velocity);
  auto densities = particles.reals(Field::density), lengths = particles.reals(Field::smoothing_length);
  auto ids = particles.integers(Field::id);
#pragma omp parallel for schedule(static)
  for (std::size_t i = range.begin; i < range.end; ++i) {
    const auto& x = body.positions[i - range.begin];
    const auto v = along_planes(body.plan.velocity->at(x), x, scene.symmetry);
    for (std::size_t k = 0; k < d; ++k) {
      positions[i * d + k] = x[static_cast<int>(k)];
      velocities[i * d + k] = v[static_cast<int>(k)];
    }
    densities[i] = body.plan.density;
    lengths[i] = scene.smoothing_ratio * body.spacing;
    ids[i] = static_cast<std::int64_t>(i);
  }
}

/// Length of the ring, or area of the shell, that a particle at this radius stands for in a radial space; 1 elsewhere.
/// A particle on the axis has half a cell, whose mean radius is a quarter of its `width`.
double about_axis(double radius, double width, Space space) {
  constexpr double pi = std::numbers::pi;
  const double mean = radius > 0.0 ? radius : 0.25 * width;
  if (hoops_of(space) == 1) return 2.0 * pi * mean;
  if (hoops_of(space) == 2)
    return radius > 0.0 ? 4.0 * pi * (radius * radius + width * width / 12.0) : pi / 3.0 * width * width;
  return 1.0;
}

/// After the regions, which may have changed densities.
void store_masses(const FilledBody& body, const Scene& scene, Range range, Particles& particles) {
  const auto& planes = scene.symmetry;
  const double volume = whole_volume(body, planes);
  const auto densities = particles.reals(Field::density);
  auto masses = particles.reals(Field::mass);
#pragma omp parallel for schedule(static)
  for (std::size_t i = range.begin; i < range.end; ++i)
    masses[i] = densities[i] * volume * mass_share(body.positions[i - range.begin], planes) *
                about_axis(body.positions[i - range.begin][0], body.step_along_x, scene.space);
}

BodyReport describe(const FilledBody& body, const Scene& scene, Range range, const Particles& particles) {
  BodyReport report;
  report.name = body.plan.name;
  report.material = body.plan.material;
  report.count = body.positions.size();
  for (const auto& position : body.positions) report.on_symmetry_planes += mass_share(position, scene.symmetry) < 1.0;
  const auto masses = particles.reals(Field::mass).subspan(range.begin, range.size());
  report.spacing = body.spacing;
  report.mass = std::accumulate(masses.begin(), masses.end(), 0.0);
  const double mean_density =
      report.mass / (whole_volume(body, scene.symmetry) * whole_particles(body, scene.symmetry));
  if (hoops_of(scene.space) == 0) report.exact_mass = mean_density * body.exact_measure;
  report.mass_spread = body.plan.arrangement.mass == MassRule::exact;
  report.remarks = body.plan.shape->remarks();
  report.warnings = body.warnings;
  return report;
}

}  // namespace

Result build_particles(Document& document, double most_particles) {
  auto root = document.root();
  const auto scene = read_scene(root, Stage::preprocess);
  const auto densities = read_densities(root);
  auto plans = read_bodies(root, scene, densities);
  for (const auto& plan : plans)
    if (hoops_of(scene.space) > 0 && plan.arrangement.mass == MassRule::exact)
      throw plan.section.fault("arrangement", "the exact mass of what a section sweeps about the axis is not known",
                               "mass = \"cell\"");
  root.finish();

  std::vector<FilledBody> filled;
  for (auto& plan : plans) {
    filled.push_back(fill_body(std::move(plan), scene.symmetry, most_particles));
    most_particles -= static_cast<double>(filled.back().positions.size());
  }
  check_overlaps(filled);

  Result result;
  auto& particles = result.snapshot.particles;
  particles = Particles(scene.space, ranges(filled));
  for (const auto field :
       {Field::id, Field::position, Field::velocity, Field::mass, Field::density, Field::smoothing_length})
    particles.allocate(field);
  for (const auto& body : filled) allocate_region_fields(body.plan.regions, particles);
  for (std::size_t k = 0; k < filled.size(); ++k) {
    const auto range = particles.bodies()[k].range;
    store(filled[k], scene, range, particles);
    auto regions =
        lay_regions(filled[k].plan.regions, scene.symmetry, edge_tolerance * filled[k].spacing, range, particles);
    store_masses(filled[k], scene, range, particles);
    result.bodies.push_back(describe(filled[k], scene, range, particles));
    result.bodies.back().regions = std::move(regions);
    filled[k].positions = {};
  }
  result.snapshot.state["time"] = 0.0;
  result.snapshot.scene = document.text();
  return result;
}

}  // namespace tektite::preprocess
