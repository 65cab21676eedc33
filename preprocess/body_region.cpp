#include "preprocess/body_region.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>

#include "core/plain_name.hpp"
#include "preprocess/dealing.hpp"
#include "preprocess/geometry/registry.hpp"
#include "preprocess/point_of.hpp"
#include "preprocess/symmetry.hpp"

namespace tektite::preprocess {
namespace {

const std::array<std::string, 2> kernel_names{"total-lagrangian", "eulerian"};  ///< in the order of KernelType

std::optional<KernelType> read_kernel(Section& section) {
  if (!section.has("kernel")) return std::nullopt;
  return section.choice("kernel", kernel_names) == kernel_names[0] ? KernelType::total_lagrangian
                                                                   : KernelType::eulerian;
}

BodyRegion read_region(const std::string& name, Section& section, Space space) {
  if (!is_plain_name(name)) throw section.fault("", "stands in reports, so it must be plain", plain_characters);
  BodyRegion region{name, read_shape(section.section("shape"), dimensions_of(space)), {}, {}, {}, {}, {}, section};
  if (section.has("density")) region.density = section.quantity("density", dimension::density, limits::positive);
  if (section.has("specific_internal_energy"))
    region.energy = section.quantity("specific_internal_energy", dimension::specific_energy, limits::not_negative);
  region.kernel = read_kernel(section);
  if (section.has("clamped")) region.clamped = section.flag("clamped", false);
  if (section.has("velocity")) region.velocity = read_velocity(section, space);
  section.finish();
  if (!region.density && !region.energy && !region.kernel && !region.clamped && !region.velocity)
    throw section.fault("", "the region asks for nothing",
                        "one or more of density, specific_internal_energy, kernel, clamped, velocity");
  if (region.velocity && region.clamped.value_or(false))
    throw section.fault("velocity", "a clamped particle does not move", "velocity or clamped = true");
  return region;
}

void set_velocity(const Point& velocity, std::size_t particle, Particles& particles) {
  const auto d = static_cast<std::size_t>(particles.dimensions());
  for (std::size_t k = 0; k < d; ++k)
    particles.reals(Field::velocity)[particle * d + k] = velocity[static_cast<int>(k)];
}

void lay(const BodyRegion& region, std::span<const SymmetryPlane> planes, std::size_t particle, const Point& x,
         Particles& particles) {
  if (region.density) particles.reals(Field::density)[particle] = *region.density;
  if (region.energy) particles.reals(Field::specific_internal_energy)[particle] = *region.energy;
  if (region.kernel) particles.integers(Field::kernel_type)[particle] = static_cast<std::int64_t>(*region.kernel);
  if (region.clamped) particles.integers(Field::clamped)[particle] = *region.clamped ? 1 : 0;
  if (region.velocity) set_velocity(along_planes(region.velocity->at(x), x, planes), particle, particles);
}

void stop_clamped(Range range, Particles& particles) {
  const auto clamped = particles.integers(Field::clamped);
  for (auto i = range.begin; i < range.end; ++i)
    if (clamped[i] != 0) set_velocity({}, i, particles);
}

std::string in_words(const BodyRegion& region) {
  std::vector<std::string> words;
  if (region.density) words.push_back(fmt::format("density {:g} kg/m3", *region.density));
  if (region.energy) words.push_back(fmt::format("energy {:g} J/kg", *region.energy));
  if (region.kernel) words.push_back(kernel_names[static_cast<std::size_t>(*region.kernel)] + " kernel");
  if (region.clamped) words.emplace_back(*region.clamped ? "clamped" : "not clamped");
  if (region.velocity) words.emplace_back("a velocity of its own");
  return join(words);
}

}  // namespace

std::vector<BodyRegion> read_regions(Section& body, Space space) {
  std::vector<BodyRegion> regions;
  for (auto& [name, section] : body.named_sections("region")) regions.push_back(read_region(name, section, space));
  return regions;
}

void allocate_region_fields(std::span<const BodyRegion> regions, Particles& particles) {
  for (const auto& region : regions) {
    if (region.energy) particles.allocate(Field::specific_internal_energy);
    if (region.kernel) particles.allocate(Field::kernel_type);
    if (region.clamped) particles.allocate(Field::clamped);
  }
}

std::vector<RegionReport> lay_regions(std::span<const BodyRegion> regions, std::span<const SymmetryPlane> planes,
                                      double tolerance, Range range, Particles& particles) {
  std::vector<RegionReport> reports;
  for (const auto& region : regions) {
    std::size_t count = 0;
#pragma omp parallel for schedule(dynamic, 1024) reduction(+ : count)
    for (auto i = range.begin; i < range.end; ++i) {
      const auto x = point_of(particles, i);
      if (!region.shape->inside(x, tolerance)) continue;
      lay(region, planes, i, x, particles);
      ++count;
    }
    count = on_all_ranks(count);
    if (count == 0) throw region.section.fault("shape", "no particle of the body lies in this region");
    reports.push_back({region.name, count, in_words(region)});
  }
  if (std::any_of(regions.begin(), regions.end(), [](const auto& region) { return region.clamped.has_value(); }))
    stop_clamped(range, particles);
  return reports;
}

}  // namespace tektite::preprocess
