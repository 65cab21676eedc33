#include "postprocess/page/page.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <functional>
#include <iostream>

#include "core/version.hpp"
#include "core/write_beside.hpp"
#include "postprocess/page/html.hpp"
#include "postprocess/page/plot.hpp"
#include "postprocess/page/style.hpp"
#include "postprocess/render/chart.hpp"
#include "postprocess/shown_unit.hpp"

namespace tektite {
namespace {

using Json = nlohmann::ordered_json;
using Runs = std::vector<RunData>;

std::string shown(double value, const ShownUnit& unit) {
  return fmt::format("{:.4g}{}{}", value * unit.factor, unit.label.empty() ? "" : " ", unit.label);
}

std::string cell(const std::string& text) { return "<td>" + escaped(text) + "</td>"; }

std::string row(const std::string& name, const std::string& cells) {
  return "<tr><th>" + escaped(name) + "</th>" + cells + "</tr>\n";
}

/// The head of a table with a column a run.
std::string run_heads(const Runs& runs, const std::string& first) {
  std::string heads = "<tr>" + first;
  for (const auto& run : runs) heads += "<th>" + escaped(run.folder) + "</th>";
  return heads + "</tr>\n";
}

/// A number of the run with its unit, empty where the run does not have it.
std::string number(const Json& file, const std::string& key, const std::string& unit) {
  const auto found = file.find(key);
  if (found == file.end() || !found->is_number()) return {};
  return shown(found->get<double>(), shown_unit(found->get<double>(), unit));
}

std::string word(const Json& file, const std::string& key) {
  const auto found = file.find(key);
  return found != file.end() && found->is_string() ? found->get<std::string>() : std::string();
}

std::string words(const Json& file, const std::string& key) {
  std::string joined;
  if (const auto found = file.find(key); found != file.end() && found->is_array())
    for (const auto& name : *found)
      if (name.is_string()) joined += (joined.empty() ? "" : ", ") + name.get<std::string>();
  return joined;
}

std::string summary(const Runs& runs) {
  const std::vector<std::pair<std::string, std::function<std::string(const RunData&)>>> rows{
      {"scene", [](const RunData& r) { return r.title; }},
      {"variant", [](const RunData& r) { return word(r.measurements, "variant"); }},
      {"scheme", [](const RunData& r) { return word(r.measurements, "scheme"); }},
      {"space", [](const RunData& r) { return r.space; }},
      {"kernel", [](const RunData& r) { return r.kernel; }},
      {"particles", [](const RunData& r) { return fmt::format("{}", r.measurements.value("particles", 0)); }},
      {"until", [](const RunData& r) { return number(r.measurements, "time", "s"); }},
      {"steps", [](const RunData& r) { return fmt::format("{}", r.measurements.value("steps", 0)); }},
      {"processor time", [](const RunData& r) { return number(r.measurements, "cpu_seconds", "s"); }},
      {"wall time", [](const RunData& r) { return number(r.measurements, "wall_seconds", "s"); }},
      {"threads", [](const RunData& r) { return fmt::format("{}", r.measurements.value("threads", 0)); }},
      {"particle-steps per second",
       [](const RunData& r) { return number(r.measurements, "particle_steps_per_second", "1"); }},
      {"peak memory",
       [](const RunData& r) {
         return fmt::format("{:.0f} MB", 1e-6 * r.measurements.value("peak_memory_bytes", 0.0));
       }},
      {"energy drift", [](const RunData& r) { return number(r.measurements, "energy_drift", "1"); }},
      {"momentum drift", [](const RunData& r) { return number(r.measurements, "momentum_drift", "1"); }},
      {"angular momentum drift",
       [](const RunData& r) { return number(r.measurements, "angular_momentum_drift", "1"); }},
      {"warnings", [](const RunData& r) { return words(r.measurements, "warnings"); }},
      {"version", [](const RunData& r) { return word(r.measurements, "version"); }}};
  std::string table = "<h2>Runs and their cost</h2>\n<table>\n" + run_heads(runs, "<th></th>");
  for (const auto& [name, value] : rows) {
    std::string cells;
    for (const auto& run : runs) cells += cell(value(run));
    table += row(name, cells);
  }
  return table + "</table>\n";
}

/// A published value, or none, beside which the runs stand in a row of the table.
struct MeasureRow {
  std::string measure;
  std::string unit;
  std::optional<double> published;
  std::string source;
  bool operator==(const MeasureRow&) const = default;
};

/// Measures by name, each once for every published value of it.
std::vector<MeasureRow> measure_rows(const Runs& runs) {
  std::vector<MeasureRow> rows;
  const auto add = [&](const MeasureRow& next) {
    if (std::ranges::find(rows, next) == rows.end()) rows.push_back(next);
  };
  for (const auto& run : runs)
    for (const auto& reference : run.measurements["references"])
      add({reference.at("measure"), reference.at("unit"), reference.at("published").get<double>(),
           reference.at("source")});
  for (const auto& run : runs)
    for (const auto& [name, measurement] : run.measurements["measurements"].items())
      if (std::ranges::none_of(rows, [&, wanted = name](const auto& r) { return r.measure == wanted; }))
        add({name, measurement.at("unit"), std::nullopt, ""});
  std::ranges::stable_sort(rows, {}, &MeasureRow::measure);
  return rows;
}

/// "20.1 mm ± 0.2 mm (-4.0 %)": the difference where the published value holds for this run.
std::string measured(const RunData& run, const MeasureRow& row, const ShownUnit& unit) {
  std::string text;
  const auto& measurements = run.measurements["measurements"];
  if (const auto found = measurements.find(row.measure); found != measurements.end())
    text = shown(found->at("value").get<double>(), unit) + " ± " + shown(found->at("uncertainty").get<double>(), unit);
  else
    text = number(run.measurements, row.measure, row.unit);
  for (const auto& reference : run.measurements["references"]) {
    if (reference.at("measure") != row.measure || reference.at("source") != row.source) continue;
    if (reference.contains("difference") && reference["difference"].is_number())
      text += fmt::format(" ({:+.1f} %)", 100.0 * reference["difference"].get<double>());
    if (reference.contains("within")) text += reference["within"].get<bool>() ? ", within" : ", outside";
  }
  return text;
}

double magnitude(const Runs& runs, const MeasureRow& row) {
  double most = std::abs(row.published.value_or(0.0));
  for (const auto& run : runs)
    if (const auto found = run.measurements["measurements"].find(row.measure);
        found != run.measurements["measurements"].end())
      most = std::max(most, std::abs(found->at("value").get<double>()));
  return most;
}

std::string measures(const Runs& runs) {
  const auto rows = measure_rows(runs);
  if (rows.empty()) return {};
  std::string table = "<h2>Measures beside published values</h2>\n<table>\n" +
                      run_heads(runs, "<th>measure</th><th>published</th><th>source</th>");
  for (const auto& line : rows) {
    const auto unit = shown_unit(magnitude(runs, line), line.unit);
    auto cells = cell(line.published ? shown(*line.published, unit) : "") + cell(line.source);
    for (const auto& run : runs) cells += cell(measured(run, line, unit));
    table += row(line.measure, cells);
  }
  return table +
         "</table>\n<p>± is the measure's own uncertainty; in brackets the difference from the published value; within "
         "or outside of what was allowed.</p>\n";
}

/// The columns of a history that are drawn together.
struct Group {
  std::string title;
  std::function<bool(const std::string& column)> holds;
};

std::vector<Group> groups_of(const Runs& runs) {
  std::vector<Group> groups{
      {"energy", [](const std::string& column) { return column.ends_with("_energy") || column.ends_with("_work"); }}};
  std::vector<std::string> units;
  for (const auto& run : runs)
    for (const auto& column : run.history ? run.history->names() : std::vector<std::string>())
      if (column.find('.') != std::string::npos && std::ranges::find(units, unit_of_column(column)) == units.end())
        units.push_back(unit_of_column(column));
  for (const auto& unit : units)
    groups.push_back({"probes", [unit](const std::string& column) {
                        return column.find('.') != std::string::npos && unit_of_column(column) == unit;
                      }});
  return groups;
}

std::optional<Plot> plot_of(const RunData& run, const Group& group) {
  if (!run.history) return std::nullopt;
  Plot plot;
  plot.title = group.title;
  plot.times = run.history->column("time");
  for (const auto& column : run.history->names())
    if (group.holds(column)) plot.curves.push_back({column, run.history->column(column)});
  if (plot.curves.empty() || plot.times.empty()) return std::nullopt;
  plot.si_unit = unit_of_column(plot.curves.front().label);
  for (const auto& curve : plot.curves)
    for (const double value : curve.values) {
      plot.least = std::min(plot.least, value);
      plot.most = std::max(plot.most, value);
    }
  plot.last = plot.times.back();
  return plot;
}

/// Figures of the same thing side by side, a column a run; empty where no run has one.
std::string side_by_side(const Runs& runs, const std::function<std::string(const RunData&)>& figure) {
  std::string figures;
  bool any = false;
  for (const auto& run : runs) {
    const auto one = figure(run);
    any = any || !one.empty();
    figures += "<figure>" + one + "<figcaption>" + escaped(run.folder) + "</figcaption></figure>\n";
  }
  return any ? "<div class=\"row\">\n" + figures + "</div>\n" : std::string();
}

/// Axes are the same for all runs.
std::string histories(const Runs& runs) {
  std::string rows;
  for (const auto& group : groups_of(runs)) {
    Plot ranges;
    for (const auto& run : runs)
      if (const auto plot = plot_of(run, group)) {
        ranges.least = std::min(ranges.least, plot->least);
        ranges.most = std::max(ranges.most, plot->most);
        ranges.last = std::max(ranges.last, plot->last);
      }
    rows += side_by_side(runs, [&](const RunData& run) {
      auto plot = plot_of(run, group);
      if (!plot) return std::string();
      plot->least = ranges.least;
      plot->most = ranges.most;
      plot->last = ranges.last;
      return svg_of(*plot);
    });
  }
  return rows.empty() ? rows : "<h2>Histories</h2>\n" + rows;
}

std::string file_name(const std::string& path) { return std::filesystem::path(path).filename().string(); }

std::string pictures(const Runs& runs) {
  std::vector<std::string> names;
  for (const auto& run : runs)
    for (const auto& path : run.pictures)
      if (std::ranges::find(names, file_name(path)) == names.end()) names.push_back(file_name(path));
  std::string rows;
  for (const auto& name : names)
    rows += side_by_side(runs, [&](const RunData& run) {
      for (const auto& path : run.pictures)
        if (file_name(path) == name)
          return fmt::format("<img alt=\"{}\" src=\"{}\"/>", escaped(name), data_uri(path, "image/png"));
      return std::string();
    });
  return rows.empty() ? rows : "<h2>Pictures</h2>\n" + rows;
}

std::string scenes(const Runs& runs) {
  std::string text = "<h2>Scenes as they took effect</h2>\n";
  for (const auto& run : runs) text += "<h3>" + escaped(run.folder) + "</h3>\n<pre>" + escaped(run.scene) + "</pre>\n";
  return text;
}

std::string title_of(const Runs& runs) {
  std::string title = runs.front().title;
  if (runs.size() > 1) title += fmt::format(" and {} more", runs.size() - 1);
  return escaped(title);
}

}  // namespace

std::string page_of(const std::vector<RunData>& runs) {
  return fmt::format(
      "<!DOCTYPE html>\n<html lang=\"en\">\n<head>\n<meta charset=\"utf-8\"/>\n<meta name=\"viewport\" "
      "content=\"width=device-width, initial-scale=1\"/>\n<meta name=\"color-scheme\" content=\"light "
      "dark\"/>\n<title>{0}</title>\n<style>\n{1}</style>\n</head>\n<body>\n<h1>{0}</h1>\n{2}{3}{4}{5}{6}<p>tektite "
      "{7}</p>\n</body>\n</html>\n",
      title_of(runs), page_style, summary(runs), measures(runs), histories(runs), pictures(runs), scenes(runs),
      version);
}

void write_page(const std::vector<std::string>& folders, const std::string& path) {
  std::vector<RunData> runs;
  for (const auto& folder : folders) runs.push_back(read_run_data(folder));
  write_text_beside(path, page_of(runs));
  std::cout << "report: " << path << '\n';
}

}  // namespace tektite
