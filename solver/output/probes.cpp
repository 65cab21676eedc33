#include "output/probes.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <limits>

namespace tektite {
namespace {

std::vector<std::string> component_names(Rank rank, int dimensions) {
  const std::vector<std::string> axes{"x", "y", "z"};
  std::vector<std::string> names;
  if (rank == Rank::vector)
    for (int k = 0; k < dimensions; ++k) names.push_back("_" + axes[static_cast<std::size_t>(k)]);
  else if (rank == Rank::symmetric)
    names = std::vector<std::string>{"_xx", "_yy", "_zz", "_xy", "_yz", "_zx"};
  else
    names = {""};
  if (rank == Rank::symmetric) names.resize(static_cast<std::size_t>(symmetric_components(dimensions)));
  return names;
}

}  // namespace

Probes::Probes(const std::vector<Probe>& probes, const Particles& particles) {
  const auto position = particles.reals(Field::position);
  const auto width = static_cast<std::size_t>(particles.dimensions());
  for (const auto& probe : probes) {
    const auto body = std::find_if(particles.bodies().begin(), particles.bodies().end(),
                                   [&](const Body& candidate) { return candidate.name == probe.body; });
    if (body == particles.bodies().end())
      throw InputError({{}, "probe." + probe.name, probe.body, "the particles hold no such body", {}});
    Followed followed{probe, 0, 0};
    if (probe.shown != Shown::particle) {
      followed_.push_back(followed);
      continue;
    }
    double nearest = std::numeric_limits<double>::infinity();
    for (std::size_t i = body->range.begin; i < body->range.end; ++i) {
      double square = 0.0;
      for (std::size_t k = 0; k < width; ++k) {
        const double d = position[i * width + k] - probe.position[k];
        square += d * d;
      }
      if (square < nearest) {
        nearest = square;
        followed.index = i;
      }
    }
    followed.id = particles.integers(Field::id)[followed.index];
    followed_.push_back(followed);
  }
}

Probes::Probes(const std::vector<Probe>& probes, const std::map<std::string, double>& state) {
  for (const auto& probe : probes) {
    const auto saved = state.find("probe." + probe.name);
    if (saved == state.end())
      throw InputError({{}, "probe." + probe.name, {}, "the snapshot does not know this probe", {}});
    followed_.push_back({probe, static_cast<std::int64_t>(saved->second), 0});
  }
}

void Probes::save(std::map<std::string, double>& state) const {
  for (const auto& followed : followed_) state["probe." + followed.probe.name] = static_cast<double>(followed.id);
}

void Probes::append_extremes(const Probe& probe, Field field, const Particles& particles, std::vector<double>& values) {
  const auto range = std::ranges::find(particles.bodies(), probe.body, &Body::name)->range;
  const auto width = static_cast<std::size_t>(particles.components(field));
  for (std::size_t k = 0; k < width; ++k) {
    if (!particles.has(field)) {
      values.push_back(0.0);
      continue;
    }
    const auto all = particles.reals(field);
    double extreme = all[range.begin * width + k];
    for (std::size_t i = range.begin; i < range.end; ++i)
      extreme =
          probe.shown == Shown::least ? std::min(extreme, all[i * width + k]) : std::max(extreme, all[i * width + k]);
    values.push_back(extreme);
  }
}

void Probes::find(Followed& followed, const Particles& particles) {
  const auto id = particles.integers(Field::id);
  if (followed.index < id.size() && id[followed.index] == followed.id) return;
  const auto found = std::find(id.begin(), id.end(), followed.id);
  if (found == id.end())
    throw RunError(fmt::format("probe {}: its particle {} is gone", followed.probe.name, followed.id));
  followed.index = static_cast<std::size_t>(found - id.begin());
}

std::vector<std::string> Probes::columns(const Particles& particles) const {
  std::vector<std::string> names;
  for (const auto& followed : followed_)
    for (const auto field : followed.probe.fields)
      for (const auto& suffix : component_names(info(field).rank, particles.dimensions()))
        names.push_back(fmt::format("{}.{}{}", followed.probe.name, info(field).name, suffix));
  return names;
}

std::vector<double> Probes::values(const Particles& particles) {
  std::vector<double> values;
  for (auto& followed : followed_) {
    if (followed.probe.shown != Shown::particle) {
      for (const auto field : followed.probe.fields) append_extremes(followed.probe, field, particles, values);
      continue;
    }
    find(followed, particles);
    for (const auto field : followed.probe.fields) {
      const auto width = static_cast<std::size_t>(particles.components(field));
      for (std::size_t k = 0; k < width; ++k)
        values.push_back(particles.has(field) ? particles.reals(field)[followed.index * width + k] : 0.0);
    }
  }
  return values;
}

}  // namespace tektite
