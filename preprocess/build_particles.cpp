#include "preprocess/build_particles.hpp"

#include <fmt/format.h>

#include <cmath>
#include <numbers>
#include <numeric>
#include <optional>

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

/// What a particle has of its cell: half of it a symmetry plane on which it lies; in the spaces about an axis, all that
/// this sweeps.
double share_of(const FilledBody& body, const Point& position, const Scene& scene) {
  return mass_share(position, scene.symmetry) * about_axis(position[0], body.step_along_x, scene.space);
}

/// Length, area or volume (m, m² or m³) of a whole cell.
double whole_cell(const FilledBody& body, const Scene& scene) {
  if (body.plan.arrangement.mass == MassRule::cell) return body.cell;
  double shares = 0.0;
  for (const auto& position : body.positions) shares += share_of(body, position, scene);
  return body.exact_measure / shares;
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

/// After the regions, which may have changed densities.
void store_masses(const FilledBody& body, const Scene& scene, Range range, Particles& particles) {
  const double cell = whole_cell(body, scene);
  const auto densities = particles.reals(Field::density);
  auto masses = particles.reals(Field::mass);
#pragma omp parallel for schedule(static)
  for (std::size_t i = range.begin; i < range.end; ++i)
    masses[i] = densities[i] * cell * share_of(body, body.positions[i - range.begin], scene);
}

/// Nothing where the particles have the mass of the shape within a tenth: a plate of five cells and a half is just
/// within it, and a rod with particles on its surface from twelve along the radius on.
std::optional<std::string> misfit(const BodyReport& report) {
  constexpr double notable = 0.1;
  const double more = report.mass / report.exact_mass - 1.0;
  if (!(std::abs(more) > notable)) return std::nullopt;
  return fmt::format(
      "the particles have {:.0f} % {} mass than the shape, which the spacing does not fit; a spacing that divides the "
      "shape, a finer one, or arrangement.mass = 'exact', which leaves their places as they are, would",
      100.0 * std::abs(more), more > 0.0 ? "more" : "less");
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
  const auto densities = particles.reals(Field::density).subspan(range.begin, range.size());
  double volume = 0.0;
  for (std::size_t i = 0; i < range.size(); ++i) volume += masses[i] / densities[i];
  report.exact_mass = report.mass / volume * body.exact_measure;
  report.mass_spread = body.plan.arrangement.mass == MassRule::exact;
  report.remarks = body.plan.shape->remarks();
  report.warnings = body.warnings;
  if (auto warning = misfit(report)) report.warnings.push_back(std::move(*warning));
  return report;
}

}  // namespace

Result build_particles(Document& document, double most_particles) {
  auto root = document.root();
  const auto scene = read_scene(root, Stage::preprocess);
  const auto densities = read_densities(root);
  auto plans = read_bodies(root, scene, densities);
  root.finish();

  std::vector<FilledBody> filled;
  for (auto& plan : plans) {
    filled.push_back(fill_body(std::move(plan), scene, most_particles));
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
