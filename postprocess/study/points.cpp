#include "postprocess/study/points.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <nlohmann/json.hpp>

#include "core/error.hpp"

namespace tektite {
namespace {

namespace fs = std::filesystem;

std::string first_line(const fs::path& path) {
  std::ifstream file(path);
  std::string line;
  std::getline(file, line);
  return line;
}

/// A measurement, or a number of the solver's summary, which has no uncertainty.
TermValue value_of(const nlohmann::json& file, const Term& term) {
  TermValue value;
  const auto& measurements = file.at("measurements");
  if (const auto found = measurements.find(term.measure); found != measurements.end()) {
    value.value = found->at("value").get<double>();
    value.uncertainty = found->at("uncertainty").get<double>();
  } else if (file.contains(term.measure)) {
    value.value = file.at(term.measure).get<double>();
  } else {
    throw RunError(term.measure + " could not be measured");
  }
  value.error = std::abs(value.value - term.truth) / term.scale;
  return value;
}

void combine(StudyPoint& point, const std::vector<Term>& terms, bool largest) {
  const double count = static_cast<double>(terms.size());
  for (std::size_t k = 0; k < terms.size(); ++k) {
    const double error = point.terms[k].error, uncertainty = point.terms[k].uncertainty / terms[k].scale;
    if (largest && error < point.error) continue;
    point.error = largest ? error : point.error + error / count;
    point.error_uncertainty = largest ? uncertainty : point.error_uncertainty + uncertainty / count;
  }
}

StudyPoint read_point(const fs::path& runs, const Member& member, const std::vector<Term>& terms, bool largest) {
  StudyPoint point;
  if (const auto failed = runs / (member.name + ".failed"); fs::exists(failed)) {
    point.failure = first_line(failed);
    return point;
  }
  std::ifstream stream(runs / member.name / "measurements.json");
  if (!stream) {
    point.failure = "has not been run";
    return point;
  }
  try {
    const auto file = nlohmann::json::parse(stream);
    point.cost = file.at("cpu_seconds").get<double>();
    point.particles = file.at("particles").get<std::int64_t>();
    point.steps = file.at("steps").get<std::int64_t>();
    for (const auto& term : terms) point.terms.push_back(value_of(file, term));
    combine(point, terms, largest);
    return point;
  } catch (const std::exception& fault) {
    StudyPoint failed;
    failed.failure = fault.what();
    return failed;
  }
}

}  // namespace

StudyPoints read_points(const JudgedStudy& judged, const std::string& folder) {
  StudyPoints points;
  for (std::size_t l = 0; l < judged.study.lines.size(); ++l) {
    auto& line = points.lines.emplace_back();
    const auto& members = judged.study.lines[l].members;
    for (std::size_t m = 0; m < members.size(); ++m)
      line.push_back(read_point(fs::path(folder) / "runs", members[m], judged.terms[l][m], judged.judgement.largest));
  }
  return points;
}

}  // namespace tektite
