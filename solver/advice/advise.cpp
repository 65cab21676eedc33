#include "advice/advise.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "advice/contact.hpp"
#include "advice/msph_impacts.hpp"
#include "advice/plausibility.hpp"
#include "advice/reach.hpp"
#include "advice/symmetry.hpp"
#include "advice/thickness.hpp"
#include "advice/unlike_bodies.hpp"
#include "advice/viscosity.hpp"
#include "advice/weak_contacts.hpp"
#include "core/counted.hpp"
#include "run/locking.hpp"
#include "schemes/godunov_settings.hpp"

namespace tektite {
namespace {

/// How far runs of the example hvi_2d were from the published values (docs/studies/hvi_2d.md), by the number of
/// particles across the projectile.
struct Published {
  const char* scheme;
  std::array<double, 3> error;  ///< with 25, 50 and 100 particles across; 0: the run failed
};
constexpr std::array<Published, 5> published{{{"eulerian", {0.118, 0.043, 0.050}},
                                              {"adaptle", {0.162, 0.081, 0.095}},
                                              {"total-lagrangian", {0.123, 0.099, 0.0}},
                                              {"godunov-pm", {0.254, 0.114, 0.078}},
                                              {"godunov-split", {0.105, 0.118, 0.105}}}};
constexpr std::array<int, 3> across{25, 50, 100};

std::string convergence(const std::string& scheme) {
  const auto* row = std::ranges::find_if(published, [&](const Published& one) { return scheme == one.scheme; });
  if (row == published.end()) return fmt::format("; no study of an impact by {} is published", scheme);
  std::string text = "; published impacts (docs/studies/hvi_2d.md) were off by";
  for (std::size_t k = 0; k < across.size(); ++k)
    if (row->error[k] > 0.0)
      text += fmt::format("{} {:.0f} % with {}", k == 0 ? "" : ",", 100.0 * row->error[k], across[k]);
  return text + " across the projectile";
}

void advise_on_thickness(const Particles& particles, const RunSettings& settings, Advice& advice) {
  const Body* thinnest = nullptr;
  double least = 0.0;
  for (const auto& body : particles.bodies()) {
    const double through = particles_through(particles, body, settings.scene.symmetry);
    if (!thinnest || through < least) {
      thinnest = &body;
      least = through;
    }
  }
  advice.lines.push_back(fmt::format("{} through the thinnest part, {}{}",
                                     counted(static_cast<std::size_t>(std::llround(least)), "particle"), thinnest->name,
                                     convergence(settings.scheme.type)));
}

std::vector<SymmetryPlane> planes_in_use(const RunSettings& settings) {
  auto taken = settings.scene.symmetry;
  if (settings.scheme.anvil) taken.push_back(*settings.scheme.anvil);
  return taken;
}

/// A number as TOML that reads back as the same.
std::string number(double value) {
  const auto text = fmt::format("{}", value);
  return text.find_first_of(".en") == std::string::npos ? text + ".0" : text;
}

std::string list(const std::vector<double>& values) {
  std::vector<std::string> texts(values.size());
  std::ranges::transform(values, texts.begin(), number);
  return fmt::format("[{}]", fmt::join(texts, ", "));
}

void advise_on_mirrors(const Particles& particles, const RunSettings& settings, Advice& advice) {
  const auto planes = unused_mirrors(particles, planes_in_use(settings));
  if (planes.empty()) return;
  std::vector<std::string> names;
  for (const auto& plane : planes) {
    const char axis = "xyz"[plane.axis];
    names.push_back(fmt::format("{} = {:g} m", axis, plane.at));
    advice.settings.push_back(
        fmt::format("symmetry.mirror_{0}={{axis='{0}', at={1}, keep='above'}}", axis, number(plane.at)));
  }
  advice.lines.push_back(
      fmt::format("bodies, materials and velocities are their own mirror images about {}: as symmetry "
                  "planes they would save a factor of {}",
                  fmt::join(names, " and "), 1 << planes.size()));
  for (const auto& probe : settings.probes) {
    auto place = probe.position;
    for (const auto& plane : planes)
      if (!place.empty()) {
        auto& x = place[static_cast<std::size_t>(plane.axis)];
        x = std::max(x, 2.0 * plane.at - x);
      }
    if (place != probe.position)
      advice.settings.push_back(fmt::format("probe.{}.position={}", probe.name, list(place)));
  }
}

bool none_has_strength(const Particles& particles, const RunSettings& settings) {
  return std::ranges::all_of(particles.bodies(), [&](const Body& body) {
    return std::holds_alternative<NoStrength>(settings.materials.at(body.material).strength);
  });
}

/// The spaces along a radius know no strength, those about an axis no [contact]; neither knows every scheme.
void advise_on_revolution(const Particles& particles, const RunSettings& settings, Advice& advice) {
  const auto lines = unused_revolutions(particles, planes_in_use(settings));
  const bool plane = particles.dimensions() == 2, radial = none_has_strength(particles, settings);
  if (lines.empty() || (plane && !radial)) return;
  if (lines.size() == 3 && radial) {
    advice.lines.push_back(
        "every body is a ball or a shell about one centre: the space spherical would do, by msph or ssph");
    return;
  }
  const auto& line = lines.front();
  advice.lines.push_back(fmt::format(
      "every body is a body of revolution about {}: the space {} would need about {:.0f} particles and save a "
      "factor of {:.0f}, by {}",
      plane ? std::string("one centre") : fmt::format("an axis along {}", "xyz"[line.axis]),
      plane ? "cylindrical" : "axisymmetric", line.section_particles,
      static_cast<double>(particles.count()) / line.section_particles,
      plane ? "msph or ssph" : "eulerian, total-lagrangian, msph or ssph without [contact]"));
}

/// Eulerian kernels leave particles on the axis in a column: it cannot make way for others, and drills ahead where the
/// material about it flows aside (seen with a rod of tungsten in steel at 1.5 km/s).
void advise_on_axis(const Particles& particles, const RunSettings& settings, const std::vector<Meeting>& meetings,
                    Advice& advice) {
  if (particles.space() != Space::axisymmetric || settings.scheme.type != "eulerian") return;
  const auto position = particles.reals(Field::position);
  const auto on_axis = [&](const Body& body) {
    for (std::size_t i = body.range.begin; i < body.range.end; ++i)
      if (position[2 * i] == 0.0) return true;
    return false;
  };
  for (const auto& meeting : meetings)
    if (on_axis(*meeting.first) && on_axis(*meeting.second))
      advice.lines.push_back(fmt::format(
          "{} and {} have particles on the axis, which Eulerian kernels cannot move aside: if one penetrates "
          "the other they drill ahead; the lattice's convention cell-centred has none there",
          meeting.first->name, meeting.second->name));
}

/// The pressure's kick comes between the two halves that strain the stress, and waves that bear shear grow by that.
void advise_on_splitting(const Particles& particles, const RunSettings& settings, Advice& advice) {
  const auto& godunov = settings.scheme.godunov;
  if (godunov && godunov->strang && !none_has_strength(particles, settings))
    advice.lines.push_back(
        "scheme.splitting = 'strang': elastic waves gain motion out of nothing in every step (docs/stability.md); "
        "lie-trotter does not, and without strength neither does");
}

/// Edges of a trimmed box, on cells of the lattice that starts at the lower corner; where nothing is trimmed, as they
/// were.
struct Edges {
  std::vector<double> lower, upper;
};

Edges trimmed(const Trim& trim, const std::vector<double>& lower, const std::vector<double>& upper) {
  const double spacing = trim.body->spacing;
  Edges edges{lower, upper};
  for (std::size_t k = 0; k < lower.size(); ++k) {
    const auto cell = [&](double x) { return lower[k] + std::round((x - lower[k]) / spacing) * spacing; };
    if (trim.lower[k] - lower[k] > 0.5 * spacing) edges.lower[k] = cell(trim.lower[k]);
    if (upper[k] - trim.upper[k] >= spacing) edges.upper[k] = cell(trim.upper[k]);
  }
  return edges;
}

/// The settings that trim a body, where its shape is a plain box filled by a lattice from its corner; else none.
std::vector<std::string> trimming(const Trim& trim, Document& document) {
  auto body = document.root().section("body").section(trim.body->name);
  auto shape = body.section("shape");
  const auto type = shape.text("type");
  auto arrangement = body.section_or_empty("arrangement");
  const bool cells = arrangement.text("type", "lattice") == "lattice" &&
                     arrangement.text("convention", "cell-centred") == "cell-centred" && !arrangement.has("count");
  if (!cells || shape.has("rotate") || shape.has("translate") || body.has("region")) return {};
  const auto name = "body." + trim.body->name + ".shape.";
  if (type == "segment") {
    const auto edges =
        trimmed(trim, {shape.quantity("lower", dimension::length)}, {shape.quantity("upper", dimension::length)});
    return {name + "lower=" + number(edges.lower[0]), name + "upper=" + number(edges.upper[0])};
  }
  if (type != "box" && type != "rectangle") return {};
  const auto width = trim.lower.size();
  const auto edges = trimmed(trim, shape.quantities("lower", dimension::length, width),
                             shape.quantities("upper", dimension::length, width));
  return {name + "lower=" + list(edges.lower), name + "upper=" + list(edges.upper)};
}

void advise_on_reach(const Particles& particles, const RunSettings& settings, const std::vector<Meeting>& meetings,
                     Document& document, Advice& advice) {
  std::size_t spared = 0;
  for (const auto& trim : unreached(particles, settings, meetings)) {
    spared += trim.spared;
    advice.lines.push_back(
        fmt::format("no wave comes further than {:g} m from what meets {} before the end: from {} to {} m of it would "
                    "do, {} of its {}",
                    trim.distance, trim.body->name, list(trim.lower), list(trim.upper),
                    trim.body->range.size() - trim.spared, counted(trim.body->range.size(), "particle")));
    const auto reduced = trimming(trim, document);
    if (reduced.empty()) advice.lines.back() += " (its shape, arrangement or regions are to be changed by hand)";
    advice.settings.insert(advice.settings.end(), reduced.begin(), reduced.end());
  }
  if (spared > 0)
    advice.lines.push_back(
        fmt::format("what is not reached makes up a factor of {:.2g}",
                    static_cast<double>(particles.count()) / static_cast<double>(particles.count() - spared)));
}

/// Scenes of many bodies have as many lines of a kind as pairs of them; those of other kinds must not be lost in them.
void tell(std::vector<std::string> lines, Advice& advice) {
  constexpr std::size_t most = 8;
  const std::size_t more = lines.size() > most ? lines.size() - most : 0;
  std::move(lines.begin(), lines.end() - static_cast<std::ptrdiff_t>(more), std::back_inserter(advice.lines));
  if (more > 0) advice.lines.push_back(fmt::format("and {} more of this kind", more));
}

std::vector<std::string> locks(const Particles& particles, const RunSettings& settings) {
  std::vector<std::string> lines;
  for (const auto& body : particles.bodies())
    if (auto line = locking(body.name, settings.materials.at(body.material))) lines.push_back(std::move(*line));
  return lines;
}

}  // namespace

Advice advise(const Particles& particles, const RunSettings& settings, const std::vector<Meeting>& meetings,
              Document& document) {
  Advice advice;
  const double end = settings.from_contact ? std::numeric_limits<double>::infinity() : settings.end;
  tell(implausible(settings.materials), advice);
  tell(implausible_end(particles, settings), advice);
  tell(in_words(meetings, end), advice);
  tell(out_of_range(meetings, settings.materials, end), advice);
  tell(misses(particles), advice);
  tell(strangers(particles), advice);
  advise_on_thickness(particles, settings, advice);
  tell(viscous_strengths(particles, settings, meetings), advice);
  tell(locks(particles, settings), advice);
  tell(slow_contacts(particles, settings, meetings), advice);
  tell(weak_contacts(particles, settings, meetings), advice);
  tell(unlike_bodies(particles, settings, meetings), advice);
  tell(rough_contacts(particles, settings, meetings), advice);
  tell(msph_impacts(particles, settings, meetings), advice);
  advise_on_axis(particles, settings, meetings, advice);
  advise_on_splitting(particles, settings, advice);
  advise_on_mirrors(particles, settings, advice);
  advise_on_revolution(particles, settings, advice);
  advise_on_reach(particles, settings, meetings, document, advice);
  return advice;
}

}  // namespace tektite
