#include "run/run_settings.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "core/plain_name.hpp"
#include "parallel/reduce.hpp"

namespace tektite {
namespace {

/// Fields that a probe may show.
std::vector<std::string> field_names() {
  std::vector<std::string> names;
  for (const auto& row : field_table)
    if (row.keep == Keep::result && row.rank != Rank::integer) names.emplace_back(row.name);
  return names;
}

std::vector<Probe> read_probes(Section& root, const Scene& scene) {
  std::vector<Probe> probes;
  for (auto& [name, section] : root.named_sections("probe")) {
    if (!is_plain_name(name))
      throw section.fault("", "names columns of history.csv, so it must be plain", plain_characters);
    Probe probe{name, section.text("body"), Shown::particle, {}, {}};
    if (section.has("extreme")) {
      const std::array<std::string, 2> extremes{"least", "largest"};
      probe.shown = section.choice("extreme", extremes) == "least" ? Shown::least : Shown::largest;
      if (section.has("position")) throw section.fault("position", "an extreme has no place", "position or extreme");
    } else {
      probe.position =
          section.quantities("position", dimension::length, static_cast<std::size_t>(dimensions_of(scene.space)));
    }
    const bool extreme = probe.shown != Shown::particle;
    const auto known = field_names();
    const std::vector<std::string> usual{"pressure", "velocity"};
    for (const auto& field : section.texts("fields", extreme ? std::vector{usual.front()} : usual)) {
      if (std::find(known.begin(), known.end(), field) == known.end())
        throw section.fault("fields", fmt::format("unknown field \"{}\"", field), join(known));
      probe.fields.push_back(*field_named(field));
    }
    section.finish();
    probes.push_back(probe);
  }
  return probes;
}

std::vector<std::string> names_of(const std::map<std::string, Material>& materials) {
  std::vector<std::string> names;
  for (const auto& entry : materials) names.push_back(entry.first);
  return names;
}

/// Regions are preprocess' to read; whether their kernels can be is for the scheme to say.
void check_kernels(Section body, const std::string& scheme) {
  for (const auto& [name, region] : body.named_sections("region"))
    if (region.has("kernel") && scheme != "adaptle")
      throw region.fault("kernel", fmt::format("the scheme {} knows one kind of kernel", scheme),
                         "no such key, or the scheme adaptle");
}

/// Whether the particles of this material have values of the field: a temperature is that of a strength that heats,
/// while the damage or the plastic strain of what neither fails nor yields is rightly zero beside a body that does.
bool has_values(const Particles& particles, const Material& material, Field field) {
  const bool heats = std::visit([](const auto& model) { return model.kind.heats; }, material.strength);
  return particles.has(field) && (heats || field != Field::temperature);
}

}  // namespace

RunSettings read_run_settings(Document& document) {
  RunSettings settings;
  auto root = document.root();
  settings.scene = read_scene(root, Stage::solve);
  settings.scheme = read_scheme(root, settings.scene);
  settings.materials = read_materials(root);

  auto time = root.section("time");
  settings.end = time.quantity("end", dimension::time, limits::positive);
  const std::array<std::string, 2> starts{"start", "contact"};
  settings.from_contact = time.choice("from", starts, "start") == "contact";
  auto bodies = root.named_sections("body");
  if (settings.from_contact && bodies.size() < 2)
    throw time.fault("from", "a contact is that of two bodies, and the scene has fewer", "start");
  time.finish();

  auto output = root.section_or_empty("output");
  constexpr double smallest = 1e-30;  // that a scene takes: below, `end` would be right and its tenth refused
  settings.snapshot_interval =
      output.quantity("snapshots", dimension::time, limits::positive, std::max(settings.end / 10.0, smallest));
  settings.history_interval = output.integer("history", {1.0, 1e9}, 1);
  output.finish();

  settings.probes = read_probes(root, settings.scene);
  std::vector<std::string> body_names;
  for (const auto& body : bodies) body_names.push_back(body.first);
  for (const auto& probe : settings.probes)
    if (std::ranges::find(body_names, probe.body) == body_names.end())
      throw root.section("probe").section(probe.name).fault("body", "there is no such body", join(body_names));
  settings.stops = read_stop_conditions(root, body_names);
  for (auto [name, body] : bodies) {
    const auto material = body.text("material");
    if (!settings.materials.contains(material))
      throw body.fault("material", "there is no such material", join(names_of(settings.materials)));
    check_kernels(body, settings.scheme.type);
  }
  root.finish();
  return settings;
}

void check_bodies(const RunSettings& settings, const Particles& particles, const std::string& file) {
  if (particles.space() != settings.scene.space)
    throw InputError({{file, 0},
                      "/@space",
                      std::string(name_of(particles.space())),
                      "the particles live in another space than the scene",
                      std::string(name_of(settings.scene.space))});
  const auto names = names_of(settings.materials);
  for (const auto& body : particles.bodies())
    if (!settings.materials.contains(body.material))
      throw InputError(
          {{file, 0}, "/bodies/" + body.name, body.material, "the scene has no such material", join(names)});
}

void check_anvil(Document& document, const RunSettings& settings, const Particles& particles) {
  if (!settings.scheme.anvil) return;
  constexpr double misfit = 0.5;  // of the spacing: by so much a lattice may lie off the surface that is at the anvil
  const auto& [axis, at, side] = *settings.scheme.anvil;
  const auto position = particles.reals(Field::position);
  const auto width = static_cast<std::size_t>(particles.dimensions());
  for (const auto& body : particles.bodies()) {
    const auto behind = [&, axis = static_cast<std::size_t>(axis), at = at, side = side](std::size_t i) {
      return side * (position[i * width + axis] - at) < -misfit * body.spacing;
    };
    if (any_over(particles, body.range, behind))
      throw document.root().section("anvil").fault(
          "at",
          fmt::format("the body {} starts behind the anvil, which would move its particles onto itself", body.name),
          "bodies on the side that `keep` tells");
  }
}

void check_probes(Document& document, const RunSettings& settings, const Particles& particles) {
  const auto position = particles.reals(Field::position);
  const auto width = static_cast<std::size_t>(particles.dimensions());
  const auto square_distance = [&](const Probe& probe, std::size_t i) {
    double square = 0.0;
    for (std::size_t k = 0; k < width; ++k) square += std::pow(position[i * width + k] - probe.position[k], 2);
    return square;
  };
  for (const auto& probe : settings.probes)
    for (const auto& body : particles.bodies()) {
      if (body.name != probe.body || probe.shown != Shown::particle) continue;
      const bool inside = any_over(particles, body.range, [&](std::size_t i) {
        return square_distance(probe, i) <= body.spacing * body.spacing;
      });
      if (!inside)
        throw document.root()
            .section("probe")
            .section(probe.name)
            .fault("position", fmt::format("lies outside the body {}", body.name),
                   fmt::format("within a spacing, {:g} m, of one of its particles", body.spacing));
    }
}

void check_probed_fields(Document& document, const RunSettings& settings, const Particles& particles) {
  for (const auto& probe : settings.probes) {
    const auto& body = *std::ranges::find(particles.bodies(), probe.body, &Body::name);
    const auto& material = settings.materials.at(body.material);
    std::vector<std::string> known;
    for (const auto& name : field_names())
      if (has_values(particles, material, *field_named(name))) known.push_back(name);
    for (const auto field : probe.fields)
      if (!has_values(particles, material, field))
        throw document.root()
            .section("probe")
            .section(probe.name)
            .fault("fields",
                   fmt::format("{} of {} has no {} by the scheme {} with the models of this scene", body.name,
                               body.material, info(field).name, settings.scheme.type),
                   join(known));
  }
}

}  // namespace tektite
