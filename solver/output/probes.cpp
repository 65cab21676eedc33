#include "output/probes.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "core/saved_number.hpp"

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

/// Of a particle from the probe's place, m.
double distance(const Probe& probe, const Particles& particles, std::size_t i) {
  const auto position = particles.reals(Field::position);
  const auto width = static_cast<std::size_t>(particles.dimensions());
  double square = 0.0;
  for (std::size_t k = 0; k < width; ++k) {
    const double d = position[i * width + k] - probe.position[k];
    square += d * d;
  }
  return std::sqrt(square);
}

/// Under which a snapshot keeps the id of the particle number `k` of a probe.
std::string state_name(const Probe& probe, std::size_t k) {
  return k == 0 ? "probe." + probe.name : fmt::format("probe.{}.{}", probe.name, k);
}

}  // namespace

Probes::Probes(const std::vector<Probe>& probes, const Particles& particles) {
  const auto id = particles.integers(Field::id);
  for (const auto& probe : probes) {
    const auto body = std::find_if(particles.bodies().begin(), particles.bodies().end(),
                                   [&](const Body& candidate) { return candidate.name == probe.body; });
    if (body == particles.bodies().end())
      throw InputError({{}, "probe." + probe.name, probe.body, "the particles hold no such body", {}});
    Followed followed{probe, {}};
    if (probe.shown != Shown::particle) {
      followed_.push_back(followed);
      continue;
    }
    double nearest = std::numeric_limits<double>::infinity();
    for (std::size_t i = body->range.begin; i < body->range.end; ++i)
      nearest = std::min(nearest, distance(probe, particles, i));
    for (std::size_t i = body->range.begin; i < body->range.end; ++i)
      if (distance(probe, particles, i) <= nearest + tie_tolerance * body->spacing)
        followed.particles.push_back({id[i], i});
    std::ranges::sort(followed.particles, {}, &Follower::id);
    followed_.push_back(followed);
  }
}

Probes::Probes(const std::vector<Probe>& probes, const std::map<std::string, double>& state) {
  for (const auto& probe : probes) {
    Followed followed{probe, {}};
    if (probe.shown == Shown::particle) {
      do {
        const auto id = saved_number(state, state_name(probe, followed.particles.size()));
        followed.particles.push_back({static_cast<std::int64_t>(id), 0});
      } while (state.contains(state_name(probe, followed.particles.size())));
    }
    followed_.push_back(followed);
  }
}

void Probes::save(std::map<std::string, double>& state) const {
  for (const auto& [probe, particles] : followed_)
    for (std::size_t k = 0; k < particles.size(); ++k)
      state[state_name(probe, k)] = static_cast<double>(particles[k].id);
}

void Probes::append_extremes(const Probe& probe, Field field, const Particles& particles, std::vector<double>& values) {
  const auto range = std::ranges::find(particles.bodies(), probe.body, &Body::name)->range;
  const auto width = static_cast<std::size_t>(particles.components(field));
  for (std::size_t k = 0; k < width; ++k) {
    const auto all = particles.reals(field);
    double extreme = all[range.begin * width + k];
    for (std::size_t i = range.begin; i < range.end; ++i)
      extreme =
          probe.shown == Shown::least ? std::min(extreme, all[i * width + k]) : std::max(extreme, all[i * width + k]);
    values.push_back(extreme);
  }
}

void Probes::append_means(const Followed& followed, Field field, const Particles& particles,
                          std::vector<double>& values) {
  const auto width = static_cast<std::size_t>(particles.components(field));
  for (std::size_t k = 0; k < width; ++k) {
    double sum = 0.0;
    for (const auto& particle : followed.particles) sum += particles.reals(field)[particle.index * width + k];
    values.push_back(sum / static_cast<double>(followed.particles.size()));
  }
}

void Probes::find(Followed& followed, const Particles& particles) {
  const auto id = particles.integers(Field::id);
  for (auto& particle : followed.particles) {
    if (particle.index < id.size() && id[particle.index] == particle.id) continue;
    const auto found = std::find(id.begin(), id.end(), particle.id);
    if (found == id.end())
      throw RunError(fmt::format("probe {}: its particle {} is gone", followed.probe.name, particle.id));
    particle.index = static_cast<std::size_t>(found - id.begin());
  }
}

std::vector<std::string> Probes::in_words(const Particles& particles) {
  std::vector<std::string> lines;
  for (auto& followed : followed_) {
    if (followed.particles.empty()) continue;
    find(followed, particles);
    std::vector<std::int64_t> ids;
    for (const auto& particle : followed.particles) ids.push_back(particle.id);
    lines.push_back(fmt::format("probe {}: {} {}, {:g} m from its place", followed.probe.name,
                                ids.size() == 1 ? "particle" : "the mean of particles", fmt::join(ids, ", "),
                                distance(followed.probe, particles, followed.particles.front().index)));
  }
  return lines;
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
    for (const auto field : followed.probe.fields) append_means(followed, field, particles, values);
  }
  return values;
}

}  // namespace tektite
