#include "advice/impact.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <limits>
#include <utility>

#include "output/progress.hpp"
#include "parallel/body_mean.hpp"
#include "physics/eos/shock_slope.hpp"

namespace tektite {
namespace {

/// Solids have u_s = c0 + s u_p with s from 1 to 2 (Marsh 1980, LASL Shock Hugoniot Data). What bends less or more is
/// no fit to a solid's Hugoniot, and tells where the compression is no longer small.
constexpr double least_slope = 1.0, largest_slope = 2.0;
constexpr double small_compression = 0.05;

/// How far every kernel reaches: there contact begins, of kernel sums and of [contact].
constexpr double support_in_smoothing_lengths = 2.0;

/// c_l + 0.6 α c, the denominator of the time step, in m/s.
double signal_speed(double sound, double shear_modulus, double density, double alpha) {
  return std::sqrt(sound * sound + 4.0 / 3.0 * shear_modulus / density) + 0.6 * alpha * sound;
}

double shortening(const Material& material, const ShockedState& shocked, double alpha) {
  const double shear = shear_modulus_of(material);
  const double rest = std::sqrt(bulk_modulus_of(material) / material.density);
  const double square = std::visit(
      [&](const auto& eos) { return sound_speed_squared(eos, shocked.density, shocked.energy); }, material.eos);
  return signal_speed(std::sqrt(square), shear, shocked.density, alpha) /
         signal_speed(rest, shear, material.density, alpha);
}

/// Nothing where the model is in its range.
std::vector<std::string> doubts(const Body& body, const Material& material, const ShockedState& shocked) {
  std::vector<std::string> doubts;
  const double compression = 1.0 - material.density / shocked.density;
  const double slope = std::visit([](const auto& eos) { return shock_slope(eos); }, material.eos);
  const auto eos = std::visit([](const auto& model) { return model.name; }, material.eos);
  if (compression > small_compression && (slope < least_slope || slope > largest_slope) && eos != IdealGas::name)
    doubts.push_back(
        fmt::format("{}: compressed by {:.0f} %, where the equation of state {} has u_s = c + {:.2g} u_p; solids have "
                    "{:g} to {:g}: "
                    "prefer a fitted Hugoniot (mie-grueneisen)",
                    body.name, 100.0 * compression, eos, slope, least_slope, largest_slope));
  if (const auto* flow = std::get_if<JohnsonCook>(&material.strength)) {
    const double left =
        std::visit([&](const auto& model) { return energy_after_release(model, shocked); }, material.eos);
    const double temperature = flow->room_temperature + left / flow->specific_heat;
    if (temperature > flow->melting_temperature)
      doubts.push_back(fmt::format(
          "{}: left at {:.0f} K after the shock, above the melting temperature {:g} K: out of the range of the flow "
          "law, and the equation of state knows no melt",
          body.name, temperature, flow->melting_temperature));
  }
  return doubts;
}

/// Two boxes, one of which moves against the other.
struct Approach {
  double speed = 0.0;    ///< of the motion, m/s; zero where the boxes do not come nearer
  double gap = 0.0;      ///< between the boxes, m
  double reach = 0.0;    ///< from which on the bodies feel each other, m
  double arrival = 0.0;  ///< when the boxes come within reach, s
  bool passes = false;   ///< whether the boxes, undeflected, never come within `reach` of each other
};

/// Of the boxes about two bodies, by their mean velocities.
Approach approach(const Particles& particles, const Body& a, const Body& b) {
  const auto va = mean_over(particles, a, Field::velocity), vb = mean_over(particles, b, Field::velocity);
  const auto position = particles.reals(Field::position), h = particles.reals(Field::smoothing_length);
  const auto width = static_cast<std::size_t>(particles.dimensions());
  const double reach = support_in_smoothing_lengths * std::max(h[a.range.begin], h[b.range.begin]);
  double along = 0.0, square = 0.0, apart = 0.0;
  double first = 0.0, last = std::numeric_limits<double>::infinity();  // when the boxes are within reach, in s
  for (std::size_t k = 0; k < width; ++k) {
    double low[2], high[2];
    for (const int side : {0, 1}) {
      const auto& range = side == 0 ? a.range : b.range;
      low[side] = high[side] = position[range.begin * width + k];
      for (std::size_t i = range.begin; i < range.end; ++i) {
        low[side] = std::min(low[side], position[i * width + k]);
        high[side] = std::max(high[side], position[i * width + k]);
      }
    }
    // Between the extents along this axis; zero where they overlap.
    const double gap = low[0] > high[1] ? low[0] - high[1] : low[1] > high[0] ? high[0] - low[1] : 0.0;
    const double speed = va[k] - vb[k];
    along += gap * speed;
    square += speed * speed;
    apart += gap * gap;
    const double before = low[1] - reach - high[0], behind = high[1] + reach - low[0];  // ways until they are in reach
    if (speed != 0.0) {
      first = std::max(first, std::min(before / speed, behind / speed));
      last = std::min(last, std::max(before / speed, behind / speed));
    } else if (before > 0.0 || behind < 0.0) {
      last = -1.0;
    }
  }
  return {along < 0.0 ? std::sqrt(square) : 0.0, std::sqrt(apart), reach, first, first > last};
}

/// Visits (first, second, approach) for every two bodies.
template <class Visit>
void each_pair(const Particles& particles, const Visit& visit) {
  const auto& bodies = particles.bodies();
  for (std::size_t a = 0; a < bodies.size(); ++a)
    for (std::size_t b = a + 1; b < bodies.size(); ++b)
      visit(bodies[a], bodies[b], approach(particles, bodies[a], bodies[b]));
}

}  // namespace

double wave_speed_at_rest(const Material& material) {
  return std::sqrt((bulk_modulus_of(material) + 4.0 / 3.0 * shear_modulus_of(material)) / material.density);
}

std::vector<Meeting> meetings(const Particles& particles, const std::map<std::string, Material>& materials) {
  std::vector<Meeting> all;
  each_pair(particles, [&](const Body& a, const Body& b, const Approach& near) {
    if (near.speed == 0.0 || near.passes) return;
    const auto shocked =
        std::visit([&](const auto& first, const auto& second) { return match_impedances(first, second, near.speed); },
                   materials.at(a.material).eos, materials.at(b.material).eos);
    all.push_back({&a, &b, near.speed, near.gap, near.arrival, shocked});
  });
  return all;
}

std::vector<std::string> misses(const Particles& particles) {
  std::vector<std::string> lines;
  each_pair(particles, [&](const Body& a, const Body& b, const Approach& near) {
    if (near.speed > 0.0 && near.passes)
      lines.push_back(
          fmt::format("{} and {} come nearer at {:.4g} m/s, but pass each other by unless something deflects "
                      "them",
                      a.name, b.name, near.speed));
  });
  return lines;
}

std::vector<std::string> strangers(const Particles& particles) {
  bool related = particles.bodies().size() < 2;
  each_pair(particles, [&](const Body&, const Body&, const Approach& near) {
    related = related || near.speed > 0.0 || near.gap <= near.reach;
  });
  if (related) return {};
  return {"no two bodies come nearer to each other by the velocities that they start with: none will meet"};
}

double step_shortening(const std::vector<Meeting>& meetings, const std::map<std::string, Material>& materials,
                       double alpha) {
  double most = 1.0;
  for (const auto& meeting : meetings) {
    if (!meeting.shocked) continue;
    most = std::max(most, shortening(materials.at(meeting.first->material), meeting.shocked->first, alpha));
    most = std::max(most, shortening(materials.at(meeting.second->material), meeting.shocked->second, alpha));
  }
  return most;
}

std::vector<std::string> in_words(const std::vector<Meeting>& meetings, double end) {
  std::vector<std::string> lines;
  const Meeting* late = nullptr;  // the first one behind the end
  for (const auto& meeting : meetings) {
    if (meeting.arrival >= end) {
      if (!late || meeting.arrival < late->arrival) late = &meeting;
      continue;
    }
    const auto names =
        fmt::format("{} meets {} at {:.4g} m/s", meeting.first->name, meeting.second->name, meeting.closing_speed);
    if (!meeting.shocked) {
      lines.push_back(names + ": an equation of state has no shock of this speed, and is out of its range");
      continue;
    }
    const auto &a = meeting.shocked->first, &b = meeting.shocked->second;
    lines.push_back(fmt::format("{}: {:.4g} GPa by Hugoniot matching, shocks of {:.4g} m/s in {} and {:.4g} m/s in {}",
                                names, 1e-9 * a.pressure, a.shock_speed, meeting.first->name, b.shock_speed,
                                meeting.second->name));
  }
  if (late)
    lines.push_back(fmt::format("{} meets {} after {} at the earliest, when the run has ended{}", late->first->name,
                                late->second->name, shown_time(late->arrival),
                                lines.empty() ? ": by then nothing has met" : "; so do all pairs that are not named"));
  return lines;
}

std::vector<std::string> out_of_range(const std::vector<Meeting>& meetings,
                                      const std::map<std::string, Material>& materials, double end) {
  std::vector<std::pair<const Body*, const ShockedState*>> hardest;
  const auto add = [&](const Body* body, const ShockedState& state) {
    const auto at = std::ranges::find(hardest, body, [](const auto& entry) { return entry.first; });
    if (at == hardest.end())
      hardest.emplace_back(body, &state);
    else if (state.pressure > at->second->pressure)
      at->second = &state;
  };
  for (const auto& meeting : meetings)
    if (meeting.shocked && meeting.arrival < end) {
      add(meeting.first, meeting.shocked->first);
      add(meeting.second, meeting.shocked->second);
    }
  std::vector<std::string> lines;
  for (const auto& [body, state] : hardest)
    std::ranges::move(doubts(*body, materials.at(body->material), *state), std::back_inserter(lines));
  return lines;
}

}  // namespace tektite
