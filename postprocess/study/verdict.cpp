#include "postprocess/study/verdict.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <limits>

#include "postprocess/accuracy/convergence.hpp"
#include "postprocess/shown_unit.hpp"

namespace tektite {
namespace {

std::string shown(double value, const std::string& si_unit, double magnitude) {
  const auto unit = shown_unit(magnitude, si_unit);
  return fmt::format("{:.4g}{}{}", value * unit.factor, unit.label.empty() ? "" : " ", unit.label);
}

std::string shown(double value, const std::string& si_unit) { return shown(value, si_unit, value); }

std::string percent(double share) { return fmt::format("{:.3g} %", 100.0 * share); }

std::string seconds(double cost) { return fmt::format("{:.3g} s", cost); }

const StudyPoint& at(const StudyPoints& points, const RunOfStudy& place) {
  return points.lines[place.line][place.member];
}

std::vector<Judged> judged_of(const StudyPoints& points, const std::vector<RunOfStudy>& places) {
  std::vector<Judged> judged;
  for (const auto& place : places) judged.push_back({at(points, place).cost, at(points, place).error});
  return judged;
}

std::vector<RunOfStudy> results_of_line(const StudyPoints& points, std::size_t line) {
  std::vector<RunOfStudy> places;
  for (const auto& place : runs_with_result(points))
    if (place.line == line) places.push_back(place);
  return places;
}

bool holds(const std::vector<RunOfStudy>& places, std::size_t line, std::size_t member) {
  return std::ranges::any_of(places, [&](const RunOfStudy& p) { return p.line == line && p.member == member; });
}

/// The order that the errors of a run and of the next coarser one with a result show; empty where there is none.
std::string rate_to_coarser(const Study& study, const StudyPoints& points, std::size_t line, std::size_t member) {
  for (std::size_t k = member; k-- > 0;) {
    if (!points.lines[line][k].failure.empty()) continue;
    const auto& members = study.lines[line].members;
    const auto order = observed_order({members[k].spacing, points.lines[line][k].error},
                                      {members[member].spacing, points.lines[line][member].error});
    return order ? fmt::format("{:.2f}", *order) : std::string();
  }
  return {};
}

std::string runs_table(const JudgedStudy& judged, const StudyPoints& points) {
  const auto front = front_of(points);
  std::string table =
      "| line | factor | spacing | particles | steps | processor time | error | of it the measures' own uncertainty "
      "| rate | front |\n|---|---|---|---|---|---|---|---|---|---|\n";
  for (std::size_t l = 0; l < points.lines.size(); ++l)
    for (std::size_t m = 0; m < points.lines[l].size(); ++m) {
      const auto& member = judged.study.lines[l].members[m];
      const auto& point = points.lines[l][m];
      table += fmt::format("| `{}` | {} | {} |", judged.study.lines[l].name, member.factor, shown(member.spacing, "m"));
      table += point.failure.empty()
                   ? fmt::format(" {} | {} | {} | {} | {} | {} | {} |\n", point.particles, point.steps,
                                 seconds(point.cost), percent(point.error), percent(point.error_uncertainty),
                                 rate_to_coarser(judged.study, points, l, m), holds(front, l, m) ? "yes" : "")
                   : fmt::format(" failed | | | | | | |\n");
    }
  return table;
}

std::string failures(const JudgedStudy& judged, const StudyPoints& points) {
  std::vector<std::pair<std::string, std::string>> names_of;  // by reason, in the order of the runs
  for (std::size_t l = 0; l < points.lines.size(); ++l)
    for (std::size_t m = 0; m < points.lines[l].size(); ++m) {
      const auto& reason = points.lines[l][m].failure;
      if (reason.empty()) continue;
      const auto name = fmt::format("`{}`", judged.study.lines[l].members[m].name);
      const auto found = std::ranges::find(names_of, reason, &std::pair<std::string, std::string>::first);
      if (found == names_of.end())
        names_of.emplace_back(reason, name);
      else
        found->second += ", " + name;
    }
  std::string text;
  for (const auto& [reason, names] : names_of) text += fmt::format("* {} failed: {}\n", names, reason);
  return text.empty() ? text : text + '\n';
}

constexpr std::array<const char*, 4> approach_names{"monotone", "oscillating", "not converging", "unchanged"};

std::string extrapolation_row(const StudyLine& line, const Term& term, const std::array<Sample, 3>& results) {
  const auto estimate = extrapolate(results);
  const double finest = results[0].value;
  auto row = fmt::format("| `{}` | {} | {} | ", line.name, term.measure, shown(finest, term.unit));
  const bool estimated = estimate.approach == Approach::monotone || estimate.approach == Approach::oscillatory;
  row += estimated ? fmt::format("{:.2f} | {} | ± {}", estimate.order, shown(estimate.value, term.unit, finest),
                                 shown(estimate.uncertainty, term.unit, finest))
                   : std::string("| |");
  return row + fmt::format(" | {} | {} |\n", approach_names[static_cast<std::size_t>(estimate.approach)],
                           term.is_norm ? "0" : shown(term.truth, term.unit));
}

/// The rows of every line with three results or more.
std::string extrapolations(const JudgedStudy& judged, const StudyPoints& points) {
  std::string rows;
  for (std::size_t l = 0; l < points.lines.size(); ++l) {
    const auto places = results_of_line(points, l);
    if (places.size() < 3) continue;
    const auto& line = judged.study.lines[l];
    for (std::size_t t = 0; t < judged.terms[l].front().size(); ++t) {
      std::array<Sample, 3> results;
      for (std::size_t k = 0; k < 3; ++k) {
        const auto& place = places[places.size() - 1 - k];
        results[k] = {line.members[place.member].spacing, at(points, place).terms[t].value};
      }
      rows += extrapolation_row(line, judged.terms[l].front()[t], results);
    }
  }
  if (rows.empty()) return {};
  return "| line | measure | finest | order | at spacing zero | grid convergence index | approach | exact or published "
         "|\n|---|---|---|---|---|---|---|---|\n" +
         rows + '\n';
}

/// The order that all errors of a line show.
std::string fitted_rates(const JudgedStudy& judged, const StudyPoints& points) {
  std::string text;
  for (std::size_t l = 0; l < points.lines.size(); ++l) {
    std::vector<Sample> errors;
    for (const auto& place : results_of_line(points, l))
      errors.push_back({judged.study.lines[l].members[place.member].spacing, at(points, place).error});
    if (const auto order = fitted_order(errors))
      text += fmt::format("{}`{}` {:.2f}", text.empty() ? "" : ", ", judged.study.lines[l].name, *order);
  }
  return text.empty() ? text : "Rate of the error over all resolutions (least squares): " + text + ".\n\n";
}

std::string what_is_judged(const JudgedStudy& judged) {
  std::string text = judged.terms.front().front().size() == 1 ? "Error: "
                     : judged.judgement.largest               ? "Error, the largest of: "
                                                              : "Error, the mean of: ";
  bool first = true;
  for (const auto& term : judged.terms.front().front()) {
    text += first ? "" : "; ";
    first = false;
    text += term.is_norm ? fmt::format("`{}`{}", term.measure,
                                       term.scale == 1.0 ? "" : fmt::format(" over {}", shown(term.scale, term.unit)))
                         : fmt::format("`{}` against {} ({})", term.measure, shown(term.truth, term.unit), term.source);
  }
  return text + ".\n\n";
}

struct Reached {
  std::size_t line;
  CostOfError cost;
};

/// The lines that reach the target, cheapest first.
std::vector<Reached> reached_by(const JudgedStudy& judged, const StudyPoints& points) {
  std::vector<Reached> reached;
  for (std::size_t l = 0; l < points.lines.size(); ++l)
    if (const auto cost = cost_of_error(judged_of(points, results_of_line(points, l)), judged.judgement.target))
      reached.push_back({l, *cost});
  std::ranges::stable_sort(reached, {}, [](const Reached& r) { return r.cost.cost; });
  return reached;
}

/// "`a` (least error 2 % at 3 s)" for every line that does not reach the target, nearest first.
std::string not_reached(const JudgedStudy& judged, const StudyPoints& points, const std::vector<Reached>& reached) {
  std::vector<RunOfStudy> best;
  for (std::size_t l = 0; l < points.lines.size(); ++l) {
    const auto places = results_of_line(points, l);
    if (places.empty() || std::ranges::any_of(reached, [&](const Reached& r) { return r.line == l; })) continue;
    best.push_back(*std::ranges::min_element(places, {}, [&](const RunOfStudy& p) { return at(points, p).error; }));
  }
  std::ranges::stable_sort(best, {}, [&](const RunOfStudy& p) { return at(points, p).error; });
  std::string text;
  for (const auto& place : best)
    text += fmt::format("{}`{}` (least error {} at {})", text.empty() ? "" : ", ", judged.study.lines[place.line].name,
                        percent(at(points, place).error), seconds(at(points, place).cost));
  return text;
}

std::string cost_in_words(const CostOfError& cost) { return (cost.at_most ? "at most " : "") + seconds(cost.cost); }

}  // namespace

std::vector<RunOfStudy> runs_with_result(const StudyPoints& points) {
  std::vector<RunOfStudy> places;
  for (std::size_t l = 0; l < points.lines.size(); ++l)
    for (std::size_t m = 0; m < points.lines[l].size(); ++m)
      if (points.lines[l][m].failure.empty()) places.push_back({l, m});
  return places;
}

std::vector<RunOfStudy> front_of(const StudyPoints& points) {
  const auto places = runs_with_result(points);
  std::vector<RunOfStudy> front;
  for (const auto k : pareto_front(judged_of(points, places))) front.push_back(places[k]);
  return front;
}

std::string study_csv(const JudgedStudy& judged, const StudyPoints& points) {
  std::string text = "line,factor,spacing,particles,steps,cpu_seconds,error,error_uncertainty,pareto_front";
  for (const auto& term : judged.terms.front().front())
    text += fmt::format(",{0},{0}_truth,{0}_uncertainty,{0}_error", term.measure);
  text += ",failure\n";
  const auto front = front_of(points);
  for (std::size_t l = 0; l < points.lines.size(); ++l)
    for (std::size_t m = 0; m < points.lines[l].size(); ++m) {
      const auto& point = points.lines[l][m];
      const auto& member = judged.study.lines[l].members[m];
      text += fmt::format("{},{},{}", judged.study.lines[l].name, member.factor, member.spacing);
      if (point.failure.empty()) {
        text += fmt::format(",{},{},{},{},{},{}", point.particles, point.steps, point.cost, point.error,
                            point.error_uncertainty, holds(front, l, m) ? 1 : 0);
        for (std::size_t t = 0; t < point.terms.size(); ++t)
          text += fmt::format(",{},{},{},{}", point.terms[t].value, judged.terms[l][m][t].truth,
                              point.terms[t].uncertainty, point.terms[t].error);
      } else {
        text += std::string(6 + 4 * judged.terms.front().front().size(), ',');
      }
      auto failure = point.failure;
      std::ranges::replace(failure, '"', '\'');
      text += failure.empty() ? ",\n" : fmt::format(",\"{}\"\n", failure);
    }
  return text;
}

std::string answer(const JudgedStudy& judged, const StudyPoints& points) {
  const auto target = percent(judged.judgement.target);
  auto text = fmt::format("Which is cheapest for an error of {}?\n\n", target);
  if (runs_with_result(points).empty()) return text + "No run has a result.\n";
  const auto reached = reached_by(judged, points);
  const auto others = not_reached(judged, points, reached);
  if (reached.empty()) return text + fmt::format("None reaches it. Nearest first: {}.\n", others);
  text += fmt::format("`{}`, with {} of processor time", judged.study.lines[reached.front().line].name,
                      cost_in_words(reached.front().cost));
  for (std::size_t k = 1; k < reached.size(); ++k)
    text += fmt::format("{} `{}` with {}", k == 1 ? "; then" : ",", judged.study.lines[reached[k].line].name,
                        cost_in_words(reached[k].cost));
  text += ". Costs are read off the straight lines between the runs, both axes logarithmic";
  if (std::ranges::any_of(reached, [](const Reached& r) { return r.cost.at_most; }))
    text += "; \"at most\": the cheapest run of the line that is good enough has no worse one beside it";
  text += ".\n";
  if (!others.empty()) text += fmt::format("Not reached by {}.\n", others);
  return text;
}

std::string study_page(const JudgedStudy& judged, const StudyPoints& points) {
  return fmt::format("# {}\n\n", judged.study.title) + what_is_judged(judged) + runs_table(judged, points) + '\n' +
         failures(judged, points) + fitted_rates(judged, points) + extrapolations(judged, points) +
         answer(judged, points);
}

}  // namespace tektite
