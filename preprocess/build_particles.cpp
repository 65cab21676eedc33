#include "preprocess/build_particles.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <optional>

#include "parallel/agreed.hpp"
#include "parallel/sums.hpp"
#include "preprocess/body.hpp"
#include "preprocess/overlap.hpp"
#include "preprocess/point_of.hpp"
#include "preprocess/symmetry.hpp"

namespace tektite::preprocess {
namespace {

/// The bodies, each of so many particles as size(body) says.
template <class Size>
std::vector<Body> ranges(const std::vector<FilledBody>& filled, const Size& size) {
  std::vector<Body> bodies;
  std::size_t first = 0;
  for (const auto& body : filled) {
    bodies.push_back({body.plan.name, body.plan.material, body.spacing, {first, first + size(body)}});
    first += size(body);
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
double whole_cell(const FilledBody& body, const Scene& scene, const Range& range, const Particles& particles) {
  if (body.plan.arrangement.mass == MassRule::cell) return body.cell;
  const auto shares = sum_over<1>(
      particles, range, [&](std::size_t i) { return std::array{share_of(body, point_of(particles, i), scene)}; });
  return body.exact_measure / shares[0];
}

/// The points are let go: the particles have them.
void store_positions(FilledBody& body, const Range& range, Particles& particles) {
  const auto d = static_cast<std::size_t>(particles.dimensions());
  auto positions = particles.reals(Field::position);
#pragma omp parallel for schedule(static)
  for (std::size_t i = range.begin; i < range.end; ++i)
    for (std::size_t k = 0; k < d; ++k) positions[i * d + k] = body.positions[i - range.begin][static_cast<int>(k)];
  body.positions = std::vector<Point>();
}

/// `first` is the number of the first particle of the range among those of all ranks.
void store(const FilledBody& body, const Scene& scene, std::size_t first, Range range, Particles& particles) {
  const auto d = static_cast<std::size_t>(particles.dimensions());
  auto velocities = particles.reals(Field::velocity);
  auto densities = particles.reals(Field::density), lengths = particles.reals(Field::smoothing_length);
  auto ids = particles.integers(Field::id);
#pragma omp parallel for schedule(static)
  for (std::size_t i = range.begin; i < range.end; ++i) {
    const auto x = point_of(particles, i);
    const auto v = along_planes(body.plan.velocity->at(x), x, scene.symmetry);
    for (std::size_t k = 0; k < d; ++k) velocities[i * d + k] = v[static_cast<int>(k)];
    densities[i] = body.plan.density;
    lengths[i] = scene.smoothing_ratio * body.spacing;
    ids[i] = static_cast<std::int64_t>(first + i - range.begin);
  }
}

/// After the regions, which may have changed densities.
void store_masses(const FilledBody& body, const Scene& scene, Range range, Particles& particles) {
  const double cell = whole_cell(body, scene, range, particles);
  const auto densities = particles.reals(Field::density);
  auto masses = particles.reals(Field::mass);
#pragma omp parallel for schedule(static)
  for (std::size_t i = range.begin; i < range.end; ++i)
    masses[i] = densities[i] * cell * share_of(body, point_of(particles, i), scene);
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
  report.count = body.count;
  report.on_symmetry_planes = count_over(
      particles, range, [&](std::size_t i) { return mass_share(point_of(particles, i), scene.symmetry) < 1.0; });
  report.spacing = body.spacing;
  const auto masses = particles.reals(Field::mass), densities = particles.reals(Field::density);
  const auto [mass, volume] = sum_over<2>(particles, range, [&](std::size_t i) {
    return std::array{masses[i], masses[i] / densities[i]};
  });
  report.mass = mass;
  report.exact_mass = report.mass / volume * body.exact_measure;
  report.mass_spread = body.plan.arrangement.mass == MassRule::exact;
  report.remarks = body.plan.shape->remarks();
  report.warnings = body.warnings;
  if (auto warning = misfit(report)) report.warnings.push_back(std::move(*warning));
  return report;
}

/// With the positions of all, and the fields that every particle has, zero yet.
Particles particles_of(std::vector<FilledBody>& filled, Space space) {
  Particles particles(space, ranges(filled, [](const FilledBody& body) { return body.positions.size(); }));
  particles.allocate(Field::position);
  for (std::size_t k = 0; k < filled.size(); ++k) store_positions(filled[k], particles.bodies()[k].range, particles);
  for (const auto field : {Field::id, Field::velocity, Field::mass, Field::density, Field::smoothing_length})
    particles.allocate(field);
  for (const auto& body : filled) allocate_region_fields(body.plan.regions, particles);
  if (ranks() > 1) {
    particles.allocate(Field::owner);
    std::ranges::fill(particles.integers(Field::owner), std::int64_t{rank()});
  }
  return particles;
}

}  // namespace

Result build_particles(Document& document, double most_particles) {
  auto root = document.root();
  const auto scene = read_scene(root, Stage::preprocess);
  const auto densities = read_densities(root);
  auto plans = agreed([&] { return read_bodies(root, scene, densities); });
  root.finish();

  std::vector<FilledBody> filled;
  for (auto& plan : plans) {
    filled.push_back(fill_body(std::move(plan), scene, most_particles));
    most_particles -= static_cast<double>(filled.back().count);
  }
  check_overlaps(filled);

  Result result;
  result.whole = ranges(filled, [](const FilledBody& body) { return body.count; });
  auto& particles = result.snapshot.particles;
  particles = particles_of(filled, scene.space);
  note_count_of_all(result.count());
  for (std::size_t k = 0; k < filled.size(); ++k) {
    const auto range = particles.bodies()[k].range;
    result.first.push_back(result.whole[k].range.begin + filled[k].first);
    store(filled[k], scene, result.first[k], range, particles);
    auto regions =
        lay_regions(filled[k].plan.regions, scene.symmetry, edge_tolerance * filled[k].spacing, range, particles);
    store_masses(filled[k], scene, range, particles);
    result.bodies.push_back(describe(filled[k], scene, range, particles));
    result.bodies.back().regions = std::move(regions);
  }
  result.snapshot.state["time"] = 0.0;
  result.snapshot.scene = document.text();
  return result;
}

}  // namespace tektite::preprocess
