#include "postprocess/report.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "core/write_beside.hpp"
#include "postprocess/shown_unit.hpp"

namespace tektite {
namespace {

/// Our value of what a reference names: a measurement, or a number of the solver's summary.
std::optional<double> ours(const Reference& reference, const Report& report, const RunFolder& run) {
  for (const auto& measurement : report.measurements)
    if (measurement.name == reference.measure) return measurement.measured.value;
  return run.number(reference.measure);
}

nlohmann::ordered_json as_json(const Reference& reference, const std::optional<double>& value) {
  nlohmann::ordered_json entry{{"measure", reference.measure},
                               {"source", reference.source},
                               {"published", reference.published},
                               {"unit", reference.unit}};
  if (reference.within) entry["allowed"] = *reference.within;
  if (!value) return entry;
  const double difference = *value - reference.published;
  entry["ours"] = *value;
  if (reference.published == 0.0)
    entry["difference"] = nullptr;
  else
    entry["difference"] = difference / std::abs(reference.published);
  if (reference.within) entry["within"] = std::abs(difference) <= *reference.within;
  return entry;
}

std::string shown(double value, const ShownUnit& unit) {
  return fmt::format("{:.4g}{}{}", value * unit.factor, unit.label.empty() ? "" : " ", unit.label);
}

std::string verdict(const Reference& reference, double difference) {
  if (!reference.within) return "";
  return std::abs(difference) <= *reference.within ? "within" : "outside";
}

constexpr const char* row = "{:<24}{:>14}{:>18}{:>14}{:>12}  {:<8} {}\n";

std::string reference_row(const Reference& reference, const Report& report, const std::optional<double>& value) {
  const auto unit = shown_unit(reference.published, reference.unit);
  const auto published = shown(reference.published, unit);
  if (!value)
    return fmt::format(fmt::runtime(row), reference.measure, "not measured", "", published, "", "", reference.source);
  std::string uncertainty;
  for (const auto& measurement : report.measurements)
    if (measurement.name == reference.measure) uncertainty = "± " + shown(measurement.measured.uncertainty, unit);
  const double difference = *value - reference.published;
  const auto relative = reference.published == 0.0
                            ? shown(difference, unit)
                            : fmt::format("{:+.1f} %", 100.0 * difference / std::abs(reference.published));
  return fmt::format(fmt::runtime(row), reference.measure, shown(*value, unit), uncertainty, published, relative,
                     verdict(reference, difference), reference.source);
}

}  // namespace

void write_measurements(const Report& report, const RunFolder& run, const std::string& path) {
  nlohmann::ordered_json file;
  file["scene"] = report.scene;
  file["variant"] = report.variant;
  for (const auto& [name, value] : run.summary.items()) file[name] = value;
  file["particles"] = report.particles;
  file["time"] = report.time;
  auto& measurements = file["measurements"] = nlohmann::ordered_json::object();
  for (const auto& [name, unit, measured] : report.measurements)
    measurements[name] = {
        {"value", measured.value}, {"unit", unit}, {"time", measured.time}, {"uncertainty", measured.uncertainty}};
  auto& references = file["references"] = nlohmann::ordered_json::array();
  for (const auto& reference : report.references)
    references.push_back(as_json(reference, ours(reference, report, run)));
  write_text_beside(path, file.dump(2) + '\n');
}

std::string comparison_table(const Report& report, const RunFolder& run) {
  if (report.references.empty() && report.measurements.empty() && report.missing.empty())
    return "nothing measured: the scene has no [measure.NAME]\n";
  std::string table =
      fmt::format(fmt::runtime(row), "measure", "ours", "uncertainty", "published", "difference", "", "source");
  for (const auto& reference : report.references)
    table += reference_row(reference, report, ours(reference, report, run));
  for (const auto& [name, si_unit, measured] : report.measurements) {
    const auto same = [&, wanted = name](const Reference& reference) { return reference.measure == wanted; };
    if (std::any_of(report.references.begin(), report.references.end(), same)) continue;
    const auto unit = shown_unit(measured.value, si_unit);
    table += fmt::format(fmt::runtime(row), name, shown(measured.value, unit), "± " + shown(measured.uncertainty, unit),
                         "", "", "", "");
  }
  for (const auto& missing : report.missing) table += "not measured: " + missing + '\n';
  return table;
}

}  // namespace tektite
