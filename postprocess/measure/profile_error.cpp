// The error of a profile along a line against an exact solution that is constant between its waves.

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "core/error.hpp"
#include "postprocess/measure/measure.hpp"

namespace tektite {
namespace {

const std::vector<std::string> profiles{"velocity", "density", "stress", "specific_internal_energy"};

Dimension dimension_of(const std::string& profile) {
  if (profile == "velocity") return dimension::speed;
  if (profile == "density") return dimension::density;
  return profile == "stress" ? dimension::pressure : dimension::specific_energy;
}

FieldSet fields_of(const std::string& profile) {
  if (profile == "stress") return {Field::pressure, Field::deviatoric_stress};
  return {field_named(profile).value()};
}

/// The values of a profile; `stress` is that along the line, compression positive.
std::vector<double> values_of(const Particles& particles, const std::string& profile) {
  std::vector<double> values(particles.count());
  for (const auto field : fields_of(profile)) require_field(particles, field);
  const bool stress = profile == "stress";
  const auto along = particles.reals(stress ? Field::pressure : field_named(profile).value());
  std::ranges::copy(along.first(values.size()), values.begin());
  if (stress) {
    const auto* s = particles.symmetrics<1>(Field::deviatoric_stress);
    for (std::size_t i = 0; i < values.size(); ++i) values[i] -= s[i](0, 0);
  }
  return values;
}

/// Where the steps begin and their values: the first value holds before the first step too.
using Steps = std::vector<std::vector<double>>;

double exact_at(const Steps& steps, double x) {
  double value = steps.front()[1];
  for (const auto& step : steps)
    if (x >= step[0]) value = step[1];
  return value;
}

double range_of(const Steps& steps) {
  const auto [least, largest] = std::ranges::minmax(steps, {}, [](const auto& step) { return step[1]; });
  return largest[1] - least[1];
}

Steps read_steps(Section& section, const std::string& profile) {
  auto steps = section.points("exact", {dimension::length, dimension_of(profile)}, 2);
  for (std::size_t k = 0; k + 1 < steps.size(); ++k)
    if (!(steps[k][0] < steps[k + 1][0]))
      throw section.fault("exact",
                          fmt::format("x = {} m does not rise to the next, {} m", steps[k][0], steps[k + 1][0]),
                          "[[x, value], ...] in the order of x");
  if (!(range_of(steps) > 0.0))
    throw section.fault("exact", "all values are the same: the error is told in shares of their range",
                        "at least two different values");
  return steps;
}

}  // namespace

/// Mean over the particles of |value - exact| in the last snapshot, over the exact solution's range. Keys: profile;
/// exact, a list of [x, value]: from x on the exact value is this. A wave lies within a spacing of where it is seen:
/// the uncertainty is the error of moving every one by half a spacing.
Measure read_error_l1(Section& section, const Declared& declared) {
  if (declared.space != Space::line) throw section.fault("", "profiles are those of a line", "line");
  const auto profile = section.choice("profile", profiles);
  const auto steps = read_steps(section, profile);
  const auto take = [=](const Event& event) {
    const auto values = values_of(event.last_snapshot.particles, profile);
    const auto& x = event.last.position;
    double sum = 0.0, moved = 0.0;
    for (std::size_t i = 0; i < values.size(); ++i) sum += std::abs(values[i] - exact_at(steps, x[i][0]));
    double length = 0.0;
    for (const auto& body : event.last.bodies) length += body.spacing * static_cast<double>(body.range.size());
    for (std::size_t k = 0; k + 1 < steps.size(); ++k)
      moved += 0.5 * event.last.bodies.front().spacing / length * std::abs(steps[k + 1][1] - steps[k][1]);
    const double range = range_of(steps);
    return Measured{sum / static_cast<double>(values.size()) / range, event.last.time, moved / range, {}};
  };
  return {take, fields_of(profile)};
}

}  // namespace tektite
