#include "postprocess/study/stability_maps.hpp"

#include <fmt/format.h>

#include <charconv>
#include <cmath>
#include <fstream>
#include <iostream>
#include <limits>
#include <map>
#include <sstream>

#include "core/stability_study.hpp"
#include "postprocess/render/apart.hpp"
#include "postprocess/render/heat_map.hpp"

namespace tektite {
namespace {

constexpr const char* growth_title = "growth x spacing / wave speed";  // the font of the charts has no Greek

using Columns = std::map<std::string, std::vector<double>>;

/// The columns of each line of the study, which the first column names.
std::map<std::string, Columns> read_table(const std::string& path) {
  std::ifstream file(path);
  std::string text;
  if (!std::getline(file, text))
    throw InputError({{path, 0}, {}, {}, "the table cannot be read", "a table of numbers"});
  std::vector<std::string> names;
  std::istringstream header(text);
  for (std::string name; std::getline(header, name, ',');) names.push_back(name);
  std::map<std::string, Columns> table;
  for (int at = 2; std::getline(file, text); ++at) {
    std::istringstream cells(text);
    std::string line, cell;
    std::getline(cells, line, ',');
    for (std::size_t k = 1; k < names.size(); ++k) {
      double value = 0.0;
      if (!std::getline(cells, cell, ',') ||
          std::from_chars(cell.data(), cell.data() + cell.size(), value).ec != std::errc())
        throw InputError({{path, at}, names[k], cell, "not a number", {}});
      table[line][names[k]].push_back(value);
    }
  }
  return table;
}

/// The values that a column has, each once, in the order of the file.
std::vector<double> different(const std::vector<double>& column) {
  std::vector<double> values;
  for (const double value : column)
    if (values.empty() || value > values.back()) values.push_back(value);
  return values;
}

const Columns& columns_of(const std::map<std::string, Columns>& table, const StabilityLine& line,
                          const std::string& path) {
  const auto found = table.find(line.name);
  if (found == table.end()) throw InputError({{path, 0}, "line", line.name, "has no rows", {}});
  return found->second;
}

HeatMap growth_map(const StabilityStudy& study, const std::string& path) {
  const auto table = read_table(path);
  HeatMap map{study.title, "smoothing length / spacing", "stress, GPa", growth_title, 0.4, 0.01, {}};
  for (const auto& line : study.lines) {
    const auto& columns = columns_of(table, line, path);
    HeatPanel panel{line.title, study.ratios, study.stresses, columns.at("growth"), {}, {}};
    for (auto& stress : panel.y) stress *= 1e-9;
    panel.along.push_back({0.0, panel.x.front(), panel.x.back()});
    // The sign of W'' in the first row under tension: a line where it changes from one h/δ to the next.
    const auto& sign = columns.at("swegle");
    const auto height = study.stresses.size();
    for (std::size_t i = 0; i + 1 < study.ratios.size(); ++i)
      if (sign[i * height + height - 1] != sign[(i + 1) * height + height - 1])
        panel.across.push_back({0.5 * (panel.x[i] + panel.x[i + 1]), panel.y.front(), panel.y.back()});
    map.panels.push_back(panel);
  }
  return map;
}

HeatMap wave_map(const StabilityStudy& study, const std::string& path, const std::string& column,
                 const std::string& title, double largest, double level) {
  const auto table = read_table(path);
  const auto where =
      fmt::format("{:.3g} GPa, smoothing length / spacing {:g}", 1e-9 * study.shown_stress, study.shown_ratio);
  HeatMap map{study.title + ": " + where, "direction, degrees", "wave number / largest", title, largest, level, {}};
  for (const auto& line : study.lines) {
    const auto& columns = columns_of(table, line, path);
    auto directions = different(columns.at("direction"));
    auto parts = columns.at("part");
    parts.resize(parts.size() / directions.size());
    map.panels.push_back({line.title, directions, parts, columns.at(column), {}, {}});
  }
  return map;
}

}  // namespace

void draw_stability(const std::string& study_file, const std::string& folder) {
  auto document = Document::load(study_file, "", {});
  auto root = document.root();
  const auto study = read_stability_study(root);
  root.finish();
  const auto growth = growth_map(study, folder + "/growth.csv");
  const auto waves = wave_map(study, folder + "/waves.csv", "growth", growth_title, 0.4, 0.01);
  const auto strain = wave_map(study, folder + "/waves.csv", "strain_share", "share of the strain seen", 1.0, 0.0);
  for (const auto& line : draw_apart([&](const Tell& tell) {
         for (const auto& [map, name] :
              {std::pair{&growth, "growth"}, std::pair{&waves, "waves"}, std::pair{&strain, "strain"}}) {
           const auto path = fmt::format("{}/{}.png", folder, name);
           draw_heat_map(*map, path);
           tell("picture: " + path);
         }
       }))
    std::cout << line << '\n';
}

}  // namespace tektite
