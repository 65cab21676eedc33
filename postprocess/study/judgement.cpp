#include "postprocess/study/judgement.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <filesystem>

#include "postprocess/plan.hpp"
#include "postprocess/references.hpp"

namespace tektite {
namespace {

constexpr std::array<const char*, 2> drifts{"energy_drift", "momentum_drift"};

struct Known {
  Dimension dimension;
  bool is_norm;
};

/// What a run of this scene can be judged by: its measures, and the drifts that the solver tells.
std::map<std::string, Known> known_of(const Plan& plan) {
  std::map<std::string, Known> known;
  for (const auto* drift : drifts) known[drift] = {dimension::none, true};
  for (const auto& measure : plan.measures)
    known[measure.name] = {measure.kind->dimension,
                           measure.kind->name.starts_with("error_") || measure.kind->name == "symmetry_error"};
  return known;
}

/// The one published value that the keys variant and source single out.
Reference published(Section& section, const Member& member, const Plan& plan, const std::string& measure) {
  const auto path = (std::filesystem::path(member.scene).parent_path() / "reference.toml").string();
  const auto variant = section.has("variant") ? section.text("variant") : member.variant;
  const auto words = section.text("source", "");
  std::vector<Reference> fitting;
  std::vector<std::string> sources;
  for (const auto& reference : read_references(path, variant, plan.measures)) {
    if (reference.measure != measure) continue;
    sources.push_back(reference.source);
    if (reference.source.find(words) != std::string::npos) fitting.push_back(reference);
  }
  if (fitting.size() == 1) return fitting.front();
  throw section.fault(
      words.empty() ? "measure" : "source",
      fmt::format("{} has {} fitting values of {} for variant \"{}\"", path, fitting.size(), measure, variant),
      sources.empty() ? "exact = ..." : "a source out of: " + join(sources));
}

Term read_term(Section& section, const Member& member, const Plan& plan) {
  const auto known = known_of(plan);
  std::vector<std::string> names;
  for (const auto& [name, kind] : known) names.push_back(name);
  Term term;
  term.measure = section.choice("measure", names);
  const auto& [dimension, is_norm] = known.at(term.measure);
  term.unit = si_unit(dimension);
  term.is_norm = is_norm;
  if (is_norm) {
    term.source = "an error norm";
    if (dimension != dimension::none && !section.has("scale"))
      throw section.fault("measure", "this norm has a unit, so a scale is needed", "scale = \"... " + term.unit + "\"");
  } else if (section.has("exact")) {
    term.truth = section.quantity("exact", dimension);
    term.source = "exact";
  } else {
    const auto reference = published(section, member, plan, term.measure);
    term.truth = reference.published;
    term.source = reference.source;
  }
  term.scale = is_norm ? 1.0 : std::abs(term.truth);
  if (section.has("scale")) term.scale = section.quantity("scale", dimension, limits::positive);
  if (!(term.scale > 0.0)) throw section.fault("measure", "should be zero, so a scale is needed", "scale = ...");
  return term;
}

}  // namespace

Judgement read_judgement(Section& root) {
  Judgement judgement;
  const std::array<std::string, 2> ways{"mean", "max"};
  judgement.largest = root.choice("combine", ways, "mean") == "max";
  judgement.target = root.quantity("target", dimension::none, limits::positive, 0.01);
  return judgement;
}

std::vector<Term> read_terms(Section& root, const Member& member) {
  auto document = member.load();
  const auto plan = read_plan(document);
  std::vector<Term> terms;
  for (auto& section : root.list("error")) {
    terms.push_back(read_term(section, member, plan));
    section.finish();
  }
  return terms;
}

JudgedStudy read_judged_study(const std::string& path) {
  auto document = Document::load(path, "", {});
  auto root = document.root();
  JudgedStudy judged{read_study(root), read_judgement(root), {}};
  for (const auto& line : judged.study.lines) {
    auto& of_line = judged.terms.emplace_back();
    for (const auto& member : line.members) of_line.push_back(read_terms(root, member));
  }
  root.finish();
  return judged;
}

}  // namespace tektite
