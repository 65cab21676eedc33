#include "run/stop_conditions.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "core/plain_name.hpp"
#include "core/saved_number.hpp"
#include "parallel/body_mean.hpp"

namespace tektite {
namespace {

using Type = StopCondition::Type;
using Place = std::array<double, 3>;

const std::vector<std::string> type_names{"perforated", "rebounded", "kinetic-energy-steady", "steady",
                                          "passes"};  // as Type

bool is_passage(const StopCondition& condition) {
  return condition.type == Type::perforated || condition.type == Type::rebounded;
}

std::string key(const StopCondition& condition, const std::string& what) {
  return fmt::format("stop_when.{}.{}", condition.name, what);
}

const Body& body_named(const Particles& particles, const std::string& name) {
  return *std::ranges::find(particles.bodies(), name, &Body::name);
}

double dot(const Place& a, const Place& b) { return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]; }

/// Of the projectile against the body.
Place relative_mean(const StopCondition& condition, const Particles& particles, Field field) {
  auto difference = mean_over(particles, body_named(particles, condition.projectile), field);
  const auto of_body = mean_over(particles, body_named(particles, condition.body), field);
  for (std::size_t k = 0; k < 3; ++k) difference[k] -= of_body[k];
  return difference;
}

struct Extent {
  double least = std::numeric_limits<double>::infinity();
  double most = -std::numeric_limits<double>::infinity();

  static void join(Extent& whole, const Extent& part) {
    whole = {std::min(whole.least, part.least), std::max(whole.most, part.most)};
  }
};

/// Of the cells of a body along a direction, from its centre.
Extent extent_along(const Particles& particles, const Body& body, const Place& direction) {
  const auto width = static_cast<std::size_t>(particles.dimensions());
  const auto position = particles.reals(Field::position);
  const double centre = dot(mean_over(particles, body, Field::position), direction);
  const auto extent = reduce(
      particles, body.range, Extent{},
      [&](Extent& so_far, std::size_t i) {
        double place = -centre;
        for (std::size_t k = 0; k < width; ++k) place += position[i * width + k] * direction[k];
        Extent::join(so_far, {place, place});
      },
      Extent::join);
  return {extent.least - 0.5 * body.spacing, extent.most + 0.5 * body.spacing};
}

}  // namespace

std::vector<StopCondition> read_stop_conditions(Section& root, const std::vector<std::string>& bodies) {
  std::vector<StopCondition> conditions;
  if (!root.has("stop_when")) return conditions;
  for (auto& [name, section] : root.named_sections("stop_when")) {
    if (!is_plain_name(name))
      throw section.fault("", "names what stopped a run, so it must be plain", plain_characters);
    StopCondition condition;
    condition.name = name;
    const bool tells = std::ranges::find(type_names, name) != type_names.end();
    const auto type = tells ? section.choice("type", type_names, name) : section.choice("type", type_names);
    condition.type = static_cast<Type>(std::ranges::find(type_names, type) - type_names.begin());
    if (is_passage(condition)) {
      condition.projectile = section.choice("projectile", bodies);
      condition.body = section.choice("body", bodies);
      if (condition.projectile == condition.body)
        throw section.fault("body", "a body does not strike itself", "another body");
    } else if (condition.type == Type::passes) {
      condition.column = section.text("column");
      condition.value = section.quantity("value", dimension::none, {}, 0.0);
    } else {
      condition.column = condition.type == Type::steady ? section.text("column") : "kinetic_energy";
      condition.tolerance = section.quantity("tolerance", dimension::none, {0.0, 1.0, true}, 0.01);
      condition.during = section.quantity("during", dimension::time, limits::positive);
    }
    section.finish();
    conditions.push_back(condition);
  }
  return conditions;
}

void check_stop_conditions(Document& document, const std::vector<StopCondition>& conditions, const Particles& particles,
                           const std::vector<std::string>& columns) {
  for (const auto& condition : conditions) {
    const auto section = [&] { return document.root().section("stop_when").section(condition.name); };
    if (is_passage(condition)) {
      const auto velocity = relative_mean(condition, particles, Field::velocity);
      if (dot(velocity, velocity) == 0.0)
        throw section().fault("projectile", "does not move against the body at the start", "a body that does");
    } else if (std::ranges::find(columns, condition.column) == columns.end()) {
      throw section().fault("column", "history.csv has no such column", join(columns));
    }
  }
}

Passage::Passage(const StopCondition& condition, const Particles& start)
    : direction_(relative_mean(condition, start, Field::velocity)) {
  const double speed = std::sqrt(dot(direction_, direction_));
  for (auto& component : direction_) component /= speed;
  const auto target = extent_along(start, body_named(start, condition.body), direction_);
  const auto projectile = extent_along(start, body_named(start, condition.projectile), direction_);
  front_ = target.least;
  rear_ = target.most;
  length_ = projectile.most - projectile.least;
}

Passage::Passage(const StopCondition& condition, const std::map<std::string, double>& state)
    : direction_{saved_number(state, key(condition, "x")), saved_number(state, key(condition, "y")),
                 saved_number(state, key(condition, "z"))},
      front_(saved_number(state, key(condition, "front"))),
      rear_(saved_number(state, key(condition, "rear"))),
      length_(saved_number(state, key(condition, "length"))) {}

void Passage::save(const StopCondition& condition, std::map<std::string, double>& state) const {
  for (std::size_t k = 0; k < 3; ++k) state[key(condition, std::string(1, "xyz"[k]))] = direction_[k];
  state[key(condition, "front")] = front_;
  state[key(condition, "rear")] = rear_;
  state[key(condition, "length")] = length_;
}

bool Passage::perforated(const StopCondition& condition, const Particles& particles) const {
  return dot(relative_mean(condition, particles, Field::position), direction_) > rear_ + length_;
}

bool Passage::rebounded(const StopCondition& condition, const Particles& particles) const {
  return dot(relative_mean(condition, particles, Field::velocity), direction_) < 0.0 &&
         dot(relative_mean(condition, particles, Field::position), direction_) < front_ - 0.5 * length_;
}

void Steadiness::save(const StopCondition& condition, std::map<std::string, double>& state) const {
  if (!since_) return;
  state[key(condition, "since")] = *since_;
  state[key(condition, "value")] = value_;
  state[key(condition, "largest")] = largest_;
}

void Steadiness::restore(const StopCondition& condition, const std::map<std::string, double>& state) {
  if (!state.contains(key(condition, "since"))) return;
  since_ = saved_number(state, key(condition, "since"));
  value_ = saved_number(state, key(condition, "value"));
  largest_ = saved_number(state, key(condition, "largest"));
}

bool Steadiness::steady(const StopCondition& condition, double time, double value) {
  largest_ = std::max(largest_, std::abs(value));
  if (!since_ || std::abs(value - value_) > condition.tolerance * largest_) {
    since_ = time;
    value_ = value;
  }
  return time - *since_ >= condition.during;
}

void Crossing::save(const StopCondition& condition, std::map<std::string, double>& state) const {
  if (side_ != 0.0) state[key(condition, "side")] = side_;
}

void Crossing::restore(const StopCondition& condition, const std::map<std::string, double>& state) {
  if (state.contains(key(condition, "side"))) side_ = saved_number(state, key(condition, "side"));
}

bool Crossing::passed(const StopCondition& condition, double value) {
  const double away = value - condition.value;
  if (side_ != 0.0) return away * side_ <= 0.0;
  if (away != 0.0) side_ = away > 0.0 ? 1.0 : -1.0;
  return false;
}

StopConditions::StopConditions(const std::vector<StopCondition>& conditions, const Particles& start,
                               const std::vector<std::string>& columns) {
  for (const auto& condition : conditions) {
    watches_.push_back({condition, std::nullopt, {}, {}, 0});
    if (is_passage(condition)) watches_.back().passage = Passage(condition, start);
  }
  met_ = watches_.size();
  find_columns(columns);
}

StopConditions::StopConditions(const std::vector<StopCondition>& conditions, const std::map<std::string, double>& state,
                               const std::vector<std::string>& columns) {
  for (const auto& condition : conditions) {
    watches_.push_back({condition, std::nullopt, {}, {}, 0});
    if (is_passage(condition)) watches_.back().passage = Passage(condition, state);
    watches_.back().steadiness.restore(condition, state);
    watches_.back().crossing.restore(condition, state);
  }
  const auto met = state.find("stop_when.met");
  met_ = met == state.end() ? watches_.size() : static_cast<std::size_t>(met->second);
  find_columns(columns);
}

void StopConditions::find_columns(const std::vector<std::string>& columns) {
  for (auto& watch : watches_)
    if (!is_passage(watch.condition))
      watch.column = static_cast<std::size_t>(std::ranges::find(columns, watch.condition.column) - columns.begin());
}

void StopConditions::save(std::map<std::string, double>& state) const {
  for (const auto& watch : watches_) {
    if (watch.passage) watch.passage->save(watch.condition, state);
    watch.steadiness.save(watch.condition, state);
    watch.crossing.save(watch.condition, state);
  }
  if (met()) state["stop_when.met"] = static_cast<double>(met_);
}

bool StopConditions::holds(Watch& watch, double time, const Particles& particles, const std::vector<double>& numbers) {
  switch (watch.condition.type) {
    case Type::perforated:
      return watch.passage->perforated(watch.condition, particles);
    case Type::rebounded:
      return watch.passage->rebounded(watch.condition, particles);
    case Type::passes:
      return watch.crossing.passed(watch.condition, numbers[watch.column]);
    default:
      return watch.steadiness.steady(watch.condition, time, numbers[watch.column]);
  }
}

void StopConditions::look(double time, const Particles& particles, const std::vector<double>& numbers) {
  for (std::size_t k = 0; k < watches_.size(); ++k)
    if (holds(watches_[k], time, particles, numbers) && !met()) met_ = k;
}

std::string in_words(const StopCondition& condition) {
  switch (condition.type) {
    case Type::perforated:
      return fmt::format("{} has perforated {}", condition.projectile, condition.body);
    case Type::rebounded:
      return fmt::format("{} has rebounded from {}", condition.projectile, condition.body);
    case Type::passes:
      return fmt::format("{} has passed {:g}", condition.column, condition.value);
    default:
      return fmt::format("{} has been steady within {:g} % for {:g} s", condition.column, 100.0 * condition.tolerance,
                         condition.during);
  }
}

}  // namespace tektite
