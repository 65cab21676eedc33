#include "postprocess/render/picture.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "core/plain_name.hpp"
#include "core/units.hpp"
#include "postprocess/render/chart.hpp"
#include "postprocess/scalar_field.hpp"

namespace tektite {
namespace {

constexpr Limits pixels{100, 10000};

Dimension dimension_of(const std::string& unit) {
  if (unit == "1") return dimension::none;
  return parse_quantity("1 " + unit).value().dimension;
}

/// Points of an exact curve of a history or a profile.
std::vector<std::vector<double>> read_exact(Section& section, const Picture& picture) {
  const bool history = picture.type == PictureType::history;
  const auto unit = history ? unit_of_column(picture.columns.front()) : scalar_field_unit(picture.field);
  return section.points("exact", {history ? dimension::time : dimension::length, dimension_of(unit)}, 2);
}

std::optional<Region> read_view(Section& picture, Space space) {
  if (!picture.has("view")) return std::nullopt;
  auto view = picture.section("view");
  const auto count = static_cast<std::size_t>(dimensions_of(space));
  Region region{view.quantities("lower", dimension::length, count), view.quantities("upper", dimension::length, count)};
  for (std::size_t k = 0; k < count; ++k)
    if (region.lower[k] >= region.upper[k]) throw view.fault("upper", "must lie above lower in every coordinate");
  view.finish();
  return region;
}

std::vector<double> read_times(Section& picture) {
  std::vector<double> times;
  for (const auto& text : picture.texts("times", {})) {
    const auto time = parse_quantity(text);
    if (!time || time->dimension != dimension::time)
      throw picture.fault("times", fmt::format("\"{}\" is not a time", text), "a list such as [\"1 us\", \"8 us\"]");
    times.push_back(time->value);
  }
  return times;
}

void read_solid_view(Section& section, Picture& picture) {
  picture.cut = section.choice("cut", cut_names, picture.cut);
  if (section.has("cut_at")) {
    if (picture.cut.size() != 1)
      throw section.fault("cut_at", "needs an axis that is cut", "cut = \"x\", \"y\" or \"z\"");
    picture.cut_at = section.quantity("cut_at", dimension::length);
  }
  if (section.has("from")) {
    const auto values = section.quantities("from", dimension::none, 3);
    picture.from = Point{values[0], values[1], values[2]};
    if (norm(*picture.from) == 0.0) throw section.fault("from", "a direction cannot be zero");
  }
}

/// What a picture of particles and a profile have in common.
void read_field(Section& section, const Declared& declared, Picture& picture) {
  picture.field = section.choice("field", scalar_field_names());
  picture.bodies = section.texts("bodies", declared.bodies);
  for (const auto& body : picture.bodies)
    if (std::find(declared.bodies.begin(), declared.bodies.end(), body) == declared.bodies.end())
      throw section.fault("bodies", fmt::format("there is no body {}", body), join(declared.bodies));
  if (section.has("times"))
    picture.times = read_times(section);
  else
    picture.all_times = section.choice("time", std::vector<std::string>{"last", "all"}, "last") == "all";
}

void read_profile(Section& section, const Declared& declared, Picture& picture) {
  picture.type = PictureType::profile;
  read_field(section, declared, picture);
  const auto dimensions = static_cast<std::size_t>(dimensions_of(declared.space));
  std::vector<std::string> known{"x", "y", "z"};
  known.resize(dimensions);
  known.emplace_back("radius");
  picture.along = section.choice("along", known, known.front());
  if (!section.has("centre")) return;
  const auto centre = section.quantities("centre", dimension::length, dimensions);
  for (std::size_t k = 0; k < dimensions; ++k) picture.centre[static_cast<int>(k)] = centre[k];
}

void read_particles(Section& section, const Declared& declared, Picture& picture) {
  read_field(section, declared, picture);
  if (section.has("range")) {
    const auto range = section.quantities("range", dimension_of(scalar_field_unit(picture.field)), 2);
    if (range[0] >= range[1]) throw section.fault("range", "must rise", "[least, largest]");
    picture.range = {range[0], range[1]};
  }
  picture.view = read_view(section, declared.space);
  if (dimensions_of(declared.space) == 3) read_solid_view(section, picture);
  picture.measures = section.flag("measures", true);
}

Picture particles_of(const std::string& field) {
  Picture picture;
  picture.name = field;
  picture.field = field;
  return picture;
}

Picture history_of(const std::string& name, const std::vector<std::string>& columns) {
  Picture picture;
  picture.name = name;
  picture.type = PictureType::history;
  picture.columns = columns;
  return picture;
}

bool is_energy(const std::string& column) { return column.ends_with("_energy") || column.ends_with("_work"); }
bool is_probed_pressure(const std::string& column) { return column.ends_with(".pressure"); }

}  // namespace

std::vector<Picture> read_pictures(Section& root, const Declared& declared) {
  const std::vector<std::string> types{"particles", "history", "profile"};
  std::vector<Picture> pictures;
  for (auto& [name, section] : root.named_sections("picture")) {
    Picture picture;
    picture.name = name;
    if (!is_plain_name(name)) throw section.fault("", "names a file, so it must be plain", plain_characters);
    const auto type = section.choice("type", types, types.front());
    if (type == "history") {
      picture.type = PictureType::history;
      picture.columns = section.texts("columns", {"kinetic_energy", "internal_energy", "total_energy"});
      if (picture.columns.empty()) throw section.fault("columns", "nothing to draw", "names of columns of history.csv");
    } else if (type == "profile") {
      read_profile(section, declared, picture);
    } else {
      read_particles(section, declared, picture);
    }
    if (type != "particles" && section.has("exact")) picture.exact = read_exact(section, picture);
    picture.width = static_cast<int>(section.integer("width", pixels, picture.width));
    picture.height = static_cast<int>(section.integer("height", pixels, picture.height));
    section.finish();
    pictures.push_back(picture);
  }
  return pictures;
}

FieldSet fields_shown(const Picture& picture) {
  if (picture.type == PictureType::history) return {};
  auto fields = fields_of_whole();
  fields.merge(scalar_field_needs(picture.field));
  return fields;
}

std::vector<Picture> default_pictures(const FieldSet& held, const std::optional<History>& history) {
  std::vector<Picture> pictures;
  for (const auto* field : {"pressure", "plastic_strain", "damage", "kernel_type"})
    if (held.contains(field_named(field).value())) pictures.push_back(particles_of(field));
  pictures.push_back(particles_of("speed"));
  pictures.push_back(particles_of("body"));
  if (!history || history->rows() < 2) return pictures;
  std::vector<std::string> energies;
  std::vector<std::string> pressures;
  for (const auto& column : history->names()) {
    if (is_energy(column)) energies.push_back(column);
    if (is_probed_pressure(column)) pressures.push_back(column);
  }
  if (!energies.empty()) pictures.push_back(history_of("energy", energies));
  if (!pressures.empty()) pictures.push_back(history_of("probes", pressures));
  return pictures;
}

}  // namespace tektite
