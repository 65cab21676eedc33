#include "preprocess/body.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <optional>

#include "core/plain_name.hpp"
#include "parallel/agreed.hpp"
#include "preprocess/dealing.hpp"
#include "preprocess/geometry/registry.hpp"
#include "preprocess/symmetry.hpp"

namespace tektite::preprocess {
namespace {

std::string read_material(Section& body, const std::map<std::string, double>& densities) {
  std::vector<std::string> names;
  for (const auto& [name, density] : densities) names.push_back(name);
  return body.choice("material", names);
}

double read_spacing(Section& body, const std::optional<double>& of_scene, bool counted) {
  if (counted) {
    if (body.has("spacing"))
      throw body.fault("spacing", "the arrangement's count gives the spacing already", "one of the two");
    return 0.0;
  }
  return of_scene ? body.quantity("spacing", dimension::length, limits::positive, *of_scene)
                  : body.quantity("spacing", dimension::length, limits::positive);
}

/// Runs work whose InputErrors do not know the scene, and tells them as faults of this key.
template <class Work>
auto as_fault_of(const Section& section, const std::string& key, const Work& work) {
  std::optional<InputError> failure;
  try {
    return work();
  } catch (const InputError& fault) {
    failure = section.fault(key, fault.what());
  }
  throw *failure;
}

constexpr const char* fewer_particles = "fewer particles, or a larger --most-particles of tektite preprocess";

void check_size(const BodyPlan& plan, double spacing, double most_particles) {
  const auto box = plan.shape->bounds();
  for (int k = 0; k < plan.shape->dimensions(); ++k)
    if (box.extent(k) < spacing * (1.0 - edge_tolerance))
      throw plan.section.fault(
          "shape",
          fmt::format("the body is thinner than one spacing: {:g} m along {} against {:g} m; is the unit right?",
                      box.extent(k), static_cast<char>('x' + k), spacing));
  for (int k = 0; k < plan.shape->dimensions(); ++k)
    if (std::max(-box.lower[k], box.upper[k]) > most_spacings * spacing)
      throw plan.section.fault("shape", fmt::format("the body reaches further from the origin than {:.0g} spacings "
                                                    "along {}; is the unit right?",
                                                    most_spacings, static_cast<char>('x' + k)));
  const double cell = plan.arrangement.arrangement->cell_factor() * std::pow(spacing, plan.shape->dimensions());
  if (const double estimate = plan.shape->measure() / cell; estimate > most_particles)
    throw plan.section.fault(
        "shape",
        fmt::format("this needs about {:.2g} particles at a spacing of {:g} m, more than {:.2g}; is "
                    "the unit right?",
                    estimate, spacing, most_particles),
        fewer_particles);
}

void check_count(const BodyPlan& plan, double most_particles) {
  const auto& wished = plan.arrangement.wished_count;
  if (wished && static_cast<double>(*wished) > most_particles)
    throw plan.section.fault("arrangement", fmt::format("a count of {} is more than {:.2g}", *wished, most_particles),
                             fewer_particles);
}

double spacing_of(const BodyPlan& plan) {
  const auto& wished = plan.arrangement.wished_count;
  if (!wished) return plan.spacing;
  return spacing_for_count(*plan.arrangement.arrangement, *plan.shape, static_cast<std::size_t>(*wished));
}

}  // namespace

std::map<std::string, double> read_densities(Section& root) {
  std::map<std::string, double> densities;
  for (auto& [name, material] : root.named_sections("material")) {
    if (!is_plain_name(name)) throw material.fault("", "stands in reports, so it must be plain", plain_characters);
    densities[name] = material.quantity("density", dimension::density, limits::positive);
    leave_others(material, Stage::preprocess);
    material.finish();
  }
  if (densities.empty()) throw root.fault("material", "the scene has no material", "[material.NAME]");
  return densities;
}

std::vector<BodyPlan> read_bodies(Section& root, const Scene& scene, const std::map<std::string, double>& densities) {
  std::optional<double> spacing;
  if (root.has("spacing")) spacing = root.quantity("spacing", dimension::length, limits::positive);
  const int dimensions = dimensions_of(scene.space);
  std::vector<BodyPlan> plans;
  for (auto& [name, body] : root.named_sections("body")) {
    if (!is_plain_name(name))
      throw body.fault("", "names rows of fragments.csv, so it must be plain", plain_characters);
    const auto material = read_material(body, densities);
    auto shape = read_shape(body.section("shape"), dimensions);
    auto arrangement = read_arrangement(body.section_or_empty("arrangement"), dimensions);
    const double own_spacing = read_spacing(body, spacing, arrangement.wished_count.has_value());
    auto velocity = read_velocity(body, scene.space);
    auto regions = read_regions(body, scene.space);
    leave_others(body, Stage::preprocess);
    body.finish();
    plans.push_back({name, material, densities.at(material), own_spacing, std::move(shape), std::move(arrangement),
                     std::move(velocity), std::move(regions), body});
  }
  if (plans.empty()) throw root.fault("body", "the scene has no body", "[body.NAME]");
  return plans;
}

FilledBody fill_body(BodyPlan plan, const Scene& scene, double most_particles) {
  const auto& planes = scene.symmetry;
  check_count(plan, most_particles);
  const double spacing = as_fault_of(plan.section, "arrangement", [&] { return spacing_of(plan); });
  check_size(plan, spacing, most_particles);
  const double kept =
      as_fault_of(plan.section, "shape", [&] { return kept_measure(*plan.shape, planes, scene.space); });
  if (kept <= 0.0) throw plan.section.fault("shape", "the body lies wholly beyond a symmetry plane");
  auto filling = agreed([&] {
    return as_fault_of(plan.section, "arrangement",
                       [&] { return plan.arrangement.arrangement->fill(*plan.shape, spacing, this_share()); });
  });
  keep_side(filling.positions, planes, edge_tolerance * spacing);
  auto dealt = deal(std::move(filling.positions));
  if (dealt.all == 0)
    throw plan.section.fault("shape", fmt::format("no particle falls inside at a spacing of {:g} m", spacing));
  auto warnings = misaligned(dealt.points, plan.shape->bounds(), spacing, planes);
  return {std::move(plan),
          std::move(dealt.points),
          dealt.first,
          dealt.all,
          spacing,
          filling.step_along_x.value_or(spacing),
          filling.cell,
          kept,
          std::move(warnings)};
}

}  // namespace tektite::preprocess
