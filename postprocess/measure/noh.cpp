// A run against the exact solution of Noh's problem (1987): cold gas of density ρ0 that runs together at speed u0 onto
// a wall, an axis or a centre (d = 1, 2, 3). Behind the shock, which runs out at u0 (γ - 1)/2,
//   ρ = ρ0 ((γ + 1)/(γ - 1))^d,  u = 0,  e = u0²/2,  p = (γ - 1) ρ e,
// and ahead of it ρ = ρ0 (1 + u0 t/r)^(d - 1), u = -u0, e = p = 0.

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <utility>
#include <vector>

#include "core/error.hpp"
#include "postprocess/measure/measure.hpp"

namespace tektite {
namespace {

struct NohState {
  double density, pressure, velocity, energy;
};

struct Noh {
  double density, speed, heat_ratio, time;
  int dimensions;

  double shock() const { return 0.5 * (heat_ratio - 1.0) * speed * time; }
  NohState at(double r) const {
    if (r > shock()) return {density * std::pow(1.0 + speed * time / r, dimensions - 1), 0.0, -speed, 0.0};
    const double rho = density * std::pow((heat_ratio + 1.0) / (heat_ratio - 1.0), dimensions);
    const double e = 0.5 * speed * speed;
    return {rho, (heat_ratio - 1.0) * rho * e, 0.0, e};
  }
};

struct NohRun {
  std::string body;
  double heat_ratio;
  double from, to;  ///< radii between which errors are taken, m
};

NohRun read_run(Section& section, const Declared& declared) {
  if (dimensions_of(declared.space) != 1)
    throw section.fault("", "the exact solution is one of a line or a radius", "space line, cylindrical or spherical");
  NohRun run{read_body(section, "body", declared), 0.0, 0.0, 0.0};
  run.heat_ratio = section.quantity("heat_ratio", dimension::none, {1.0, 10.0, true}, 5.0 / 3.0);
  run.from = section.quantity("from", dimension::length, limits::not_negative, 0.05);
  run.to = section.quantity("to", dimension::length, limits::positive, 0.35);
  return run;
}

Noh exact_of(const Event& event, const NohRun& run) {
  const auto& particles = event.last_snapshot.particles;
  const auto& body = event.initial.bodies[static_cast<std::size_t>(event.initial.body_named(run.body))];
  const auto first = body.range.begin;
  const double speed = std::abs(event.initial.velocity[body.range.end - 1][0]);
  if (!(speed > 0.0)) throw RunError("the gas does not move at the start");
  const auto start = read_fields(event.snapshots.front(), {Field::density});
  return {start.particles.reals(Field::density)[first], speed, run.heat_ratio, event.last.time,
          1 + hoops_of(particles.space())};
}

enum class Profile { density, pressure, velocity, energy };

double exact_value(const NohState& s, Profile what) {
  switch (what) {
    case Profile::density:
      return s.density;
    case Profile::pressure:
      return s.pressure;
    case Profile::velocity:
      return s.velocity;
    case Profile::energy:
      break;
  }
  return s.energy;
}

Field field_of(Profile what) {
  switch (what) {
    case Profile::density:
      return Field::density;
    case Profile::pressure:
      return Field::pressure;
    case Profile::velocity:
      return Field::velocity;
    case Profile::energy:
      break;
  }
  return Field::specific_internal_energy;
}

/// work(radius, value) for every particle of the body.
template <class Work>
void for_profile(const Event& event, const NohRun& run, Field field, const Work& work) {
  const auto& particles = event.last_snapshot.particles;
  require_field(particles, field);
  const auto& body = event.last.bodies[static_cast<std::size_t>(event.last.body_named(run.body))];
  const auto x = particles.reals(Field::position), value = particles.reals(field);
  for (auto i = body.range.begin; i < body.range.end; ++i) work(x[i], value[i]);
}

double spacing_of(const Event& event, const NohRun& run) {
  return event.last.bodies[static_cast<std::size_t>(event.last.body_named(run.body))].spacing;
}

/// The mean of |ours - exact| over the particles between two radii, where ours is moved outwards by `shift`.
double mean_difference(const Event& event, const NohRun& run, Profile what, const Noh& exact, double shift) {
  double sum = 0.0, count = 0.0;
  for_profile(event, run, field_of(what), [&](double r, double value) {
    if (r <= run.from || r >= run.to) return;
    sum += std::abs(value - exact_value(exact.at(std::max(r + shift, 0.0)), what));
    count += 1.0;
  });
  if (count == 0.0) throw RunError("no particle lies between the radii from and to");
  return sum / count;
}

/// What a particle carries is that of half a spacing to either side: the uncertainty is how far the mean difference
/// moves with it.
Measured error_l1(const Event& event, const NohRun& run, Profile what) {
  const auto exact = exact_of(event, run);
  const double half = 0.5 * spacing_of(event, run);
  const double error = mean_difference(event, run, what, exact, 0.0);
  const double outwards = mean_difference(event, run, what, exact, half);
  const double inwards = mean_difference(event, run, what, exact, -half);
  return {error, exact.time, std::max(std::abs(outwards - error), std::abs(inwards - error)), {}};
}

/// Where the velocity passes half of that ahead of the shock, from outside; linear between particles.
Measured shock_position(const Event& event, const NohRun& run) {
  const auto exact = exact_of(event, run);
  std::vector<std::pair<double, double>> profile;
  for_profile(event, run, Field::velocity, [&](double r, double v) { profile.push_back({r, v}); });
  std::ranges::sort(profile);
  const double half = -0.5 * exact.speed;
  for (std::size_t k = profile.size() - 1; k > 0; --k) {
    const auto [outer, fast] = profile[k];
    const auto [inner, slow] = profile[k - 1];
    if (slow < half) continue;
    return {inner + (outer - inner) * (half - slow) / (fast - slow), exact.time, spacing_of(event, run), {}};
  }
  throw RunError("no shock runs through the gas");
}

/// Largest energy within `from` of the axis over the exact one: 1 where the axis is not heated. Half a spacing on, it
/// is half as far from that of the particle beside it: the larger of these differences is the uncertainty.
Measured wall_heating(const Event& event, const NohRun& run) {
  const auto exact = exact_of(event, run);
  std::vector<std::pair<double, double>> profile;
  for_profile(event, run, Field::specific_internal_energy, [&](double r, double e) { profile.push_back({r, e}); });
  std::ranges::sort(profile);
  std::optional<std::size_t> hottest;
  for (std::size_t k = 0; k < profile.size() && profile[k].first < run.from; ++k)
    if (!hottest || profile[k].second > profile[*hottest].second) hottest = k;
  if (!hottest) throw RunError("no particle lies within the radius from");
  const double most = profile[*hottest].second, whole = exact.at(0.0).energy;
  double beside = 0.0;
  if (*hottest > 0) beside = std::abs(most - profile[*hottest - 1].second);
  if (*hottest + 1 < profile.size()) beside = std::max(beside, std::abs(most - profile[*hottest + 1].second));
  return {most / whole, exact.time, 0.5 * beside / whole, {}};
}

Measure read_error(Section& section, const Declared& declared, Profile what) {
  const auto run = read_run(section, declared);
  return {[=](const Event& event) { return error_l1(event, run, what); }, {Field::position, field_of(what)}};
}

}  // namespace

Measure read_error_l1_density(Section& section, const Declared& declared) {
  return read_error(section, declared, Profile::density);
}
Measure read_error_l1_pressure(Section& section, const Declared& declared) {
  return read_error(section, declared, Profile::pressure);
}
Measure read_error_l1_velocity(Section& section, const Declared& declared) {
  return read_error(section, declared, Profile::velocity);
}
Measure read_error_l1_energy(Section& section, const Declared& declared) {
  return read_error(section, declared, Profile::energy);
}
Measure read_shock_position(Section& section, const Declared& declared) {
  const auto run = read_run(section, declared);
  return {[=](const Event& event) { return shock_position(event, run); }, {Field::position, Field::velocity}};
}
Measure read_wall_heating(Section& section, const Declared& declared) {
  const auto run = read_run(section, declared);
  return {[=](const Event& event) { return wall_heating(event, run); },
          {Field::position, Field::specific_internal_energy}};
}

}  // namespace tektite
