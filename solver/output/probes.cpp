#include "output/probes.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "core/saved_number.hpp"
#include "parallel/reduce.hpp"

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
    const auto least = [](double& whole, double part) { whole = std::min(whole, part); };
    const double nearest = reduce(
        particles, body->range, std::numeric_limits<double>::infinity(),
        [&](double& so_far, std::size_t i) { least(so_far, distance(probe, particles, i)); }, least);
    Words ids;
    const Owned own(particles);
    for (std::size_t i = body->range.begin; i < body->range.end; ++i)
      if (own(i) && distance(probe, particles, i) <= nearest + tie_tolerance * body->spacing)
        ids.push_back(static_cast<Word>(id[i]));
    for (const auto& of_rank : gather_on_all(ids))
      for (const auto one : of_rank) followed.particles.push_back({static_cast<std::int64_t>(one), 0});
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
  const auto all = particles.reals(field);
  const bool least = probe.shown == Shown::least;
  const auto take = [least](double& so_far, double value) {
    so_far = least ? std::min(so_far, value) : std::max(so_far, value);
  };
  const double none = least ? std::numeric_limits<double>::infinity() : -std::numeric_limits<double>::infinity();
  for (std::size_t k = 0; k < width; ++k)
    values.push_back(reduce(
        particles, range, none, [&](double& so_far, std::size_t i) { take(so_far, all[i * width + k]); }, take));
}

template <class Values>
std::vector<double> Probes::values_of_each(Followed& followed, const Particles& particles, std::size_t width,
                                           const Values& values) {
  struct Number {
    bool known;
    double value;
  };
  std::vector<Number> numbers;
  for (auto& particle : followed.particles) {
    const bool own = find(particle, particles);
    for (std::size_t k = 0; k < width; ++k) numbers.push_back({own, own ? values(particle.index, k) : 0.0});
  }
  each_over_ranks(particles, numbers, [](Number& whole, const Number& part) {
    if (part.known) whole = part;
  });
  std::vector<double> all;
  for (std::size_t n = 0; n < numbers.size(); ++n) {
    if (!numbers[n].known)
      throw RunError(
          fmt::format("probe {}: its particle {} is gone", followed.probe.name, followed.particles[n / width].id));
    all.push_back(numbers[n].value);
  }
  return all;
}

void Probes::append_means(Followed& followed, Field field, const Particles& particles, std::vector<double>& values) {
  const auto width = static_cast<std::size_t>(particles.components(field));
  const auto numbers = values_of_each(followed, particles, width, [&](std::size_t index, std::size_t k) {
    return particles.reals(field)[index * width + k];
  });
  for (std::size_t k = 0; k < width; ++k) {
    double sum = 0.0;
    for (std::size_t n = k; n < numbers.size(); n += width) sum += numbers[n];
    values.push_back(sum / static_cast<double>(followed.particles.size()));
  }
}

bool Probes::find(Follower& particle, const Particles& particles) {
  const auto id = particles.integers(Field::id).first(particles.count());
  if (particle.index >= id.size() || id[particle.index] != particle.id)
    particle.index = static_cast<std::size_t>(std::find(id.begin(), id.end(), particle.id) - id.begin());
  return particle.index < id.size() && Owned(particles)(particle.index);
}

std::vector<std::string> Probes::in_words(const Particles& particles) {
  std::vector<std::string> lines;
  for (auto& followed : followed_) {
    if (followed.particles.empty()) continue;
    const auto distances = values_of_each(followed, particles, 1, [&](std::size_t index, std::size_t) {
      return distance(followed.probe, particles, index);
    });
    std::vector<std::int64_t> ids;
    for (const auto& particle : followed.particles) ids.push_back(particle.id);
    lines.push_back(fmt::format("probe {}: {} {}, {:g} m from its place", followed.probe.name,
                                ids.size() == 1 ? "particle" : "the mean of particles", fmt::join(ids, ", "),
                                distances.front()));
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
    for (const auto field : followed.probe.fields) append_means(followed, field, particles, values);
  }
  return values;
}

}  // namespace tektite
