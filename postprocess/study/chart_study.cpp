#include "postprocess/study/chart_study.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <iostream>

#include "core/write_beside.hpp"
#include "postprocess/render/cost_chart.hpp"
#include "postprocess/study/verdict.hpp"

namespace tektite {
namespace {

/// The title of a line, with the factors of its runs that failed.
std::string label_of(const StudyLine& line, const std::vector<StudyPoint>& points) {
  std::string failed;
  for (std::size_t m = 0; m < points.size(); ++m)
    if (!points[m].failure.empty()) failed += fmt::format("{}{}", failed.empty() ? "" : ", ", line.members[m].factor);
  if (failed.empty()) return line.title;
  const bool all = std::ranges::none_of(points, [](const auto& point) { return point.failure.empty(); });
  return fmt::format("{} (failed{})", line.title, all ? "" : " at " + failed);
}

CostChart chart_of(const JudgedStudy& judged, const StudyPoints& points) {
  CostChart chart;
  chart.title = judged.study.title;
  chart.target = judged.judgement.target;
  for (std::size_t l = 0; l < points.lines.size(); ++l)
    chart.lines.push_back({label_of(judged.study.lines[l], points.lines[l]), {}});
  for (const auto& [line, member] : runs_with_result(points))
    chart.lines[line].runs.push_back({points.lines[line][member].cost, points.lines[line][member].error});
  for (const auto& [line, member] : front_of(points))
    chart.front.push_back({points.lines[line][member].cost, points.lines[line][member].error});
  return chart;
}

}  // namespace

void check_study(const std::string& path) { read_judged_study(path); }

bool chart_study(const std::string& path, const std::string& folder) {
  const auto judged = read_judged_study(path);
  const auto points = read_points(judged, folder);
  const auto page = study_page(judged, points);
  write_text_beside(folder + "/chart.csv", study_csv(judged, points));
  write_text_beside(folder + "/chart.md", page);
  std::cout << '\n' << page << '\n';
  if (runs_with_result(points).empty()) return false;
  for (const auto& line : draw_cost_chart(chart_of(judged, points), folder + "/chart")) std::cout << line << '\n';
  return true;
}

}  // namespace tektite
