// Where bodies meet: too fast for their contact, with a stiff contact, and with other particles on the other side.
#include <fmt/format.h>

#include <catch2/catch.hpp>

#include "run/watch.hpp"
#include "support/lattice.hpp"

using namespace tektite;
using namespace tektite::test;

namespace {

constexpr double spacing = 1e-3, density = 2785.0, bulk = 79e9;
const double wave_speed = std::sqrt((bulk + 4.0 / 3.0 * 27.6e9) / density);
const std::string metal =
    "[material.metal]\ndensity = 2785.0\neos = { model = 'linear', bulk_modulus = 79e9 }\n"
    "strength = { model = 'elastic', shear_modulus = 27.6e9 }\n";
const std::string no_viscosity = "viscosity = { model = 'monaghan', alpha = 0.0, beta = 0.0 }\n";

struct Meeting {
  double apart = 0.0;       ///< speed at which the bars part, over that at which they met
  double drift = 0.0;       ///< of the energy
  bool by_contact = false;  ///< the contact has limited a time step
  std::set<std::string> names;
};

/// Two equal bars on a line run into each other at `speed` and part after a wave has run through both and back.
Meeting meet(const std::string& scheme, double speed) {
  constexpr int length = 40;
  auto simulation = simulation_of(
      fmt::format("time.end = {}\n", 6.0 * length * spacing / wave_speed + 6.0 * spacing / speed) + scheme + metal,
      particles_on(Space::line,
                   {{"left", "metal", spacing, {0.0}, {length}, {0.5 * speed}},
                    {"right", "metal", spacing, {(length + 3.0) * spacing}, {length}, {-0.5 * speed}}},
                   density));
  Meeting meeting;
  Watch watch;
  while (!simulation.finished()) {
    simulation.step();
    meeting.by_contact = meeting.by_contact || simulation.last_step().reason == StepLimit::contact;
    if (simulation.steps() % 50 == 0)
      watch.look(simulation.particles(), simulation.settings(), simulation.scheme().warnings());
  }
  meeting.names = watch.names();
  const auto v = by_id(simulation.particles(), Field::velocity);
  for (std::size_t i = 0; i < v.size(); ++i)
    meeting.apart += (i < v.size() / 2 ? -1.0 : 1.0) * v[i] / (0.5 * static_cast<double>(v.size()) * speed);
  meeting.drift = simulation.energy_drift(simulation.ledger());
  return meeting;
}

std::string with_contact(double factor) {
  return fmt::format("scheme.type = 'total-lagrangian'\ncontact.factor = {}\n", factor);
}

/// The largest pressure that the potential of the contact has between two half lines of particles, Pa: the sum over all
/// pairs of V² K_ca 4 W³ |W'|/W(δ)⁴, largest over the distance of the ends.
double largest_pressure(double factor) {
  const auto value = [](double r) {
    return r < CubicSpline::support * smoothing_ratio ? CubicSpline::shape(r / smoothing_ratio) : 0.0;
  };
  double largest = 0.0;
  for (double gap = 0.0; gap < 3.0; gap += 0.01) {
    double sum = 0.0;
    for (int n = 0; n < 4; ++n) {  // n + 1 pairs are as far apart as this
      const double r = gap + n, slope = (value(r + 1e-6) - value(std::abs(r - 1e-6))) / 2e-6;
      sum -= (n + 1) * 4.0 * std::pow(value(r), 3) * slope / std::pow(value(1.0), 4);
    }
    largest = std::max(largest, factor * bulk * sum);
  }
  return largest;
}

struct Pulse {
  double passed, returned;  ///< largest velocity of what goes on and of what comes back, over the exact ones
};

/// A pulse of velocity runs through a liquid into one that is `heavier` and whose particles are `wider` apart.
Pulse through_contact(const std::string& scheme, double heavier, double wider) {
  constexpr int left = 400;
  constexpr double amplitude = 1e-4, sound_speed = 1.0, width = 40.0, delta = 1.0;
  const int right = static_cast<int>(200 / wider);
  auto p = particles_on(Space::line,
                        {{"light", "light", delta, {0.5 * delta}, {left}, {0.0}},
                         {"heavy", "heavy", wider * delta, {left * delta + 0.5 * wider * delta}, {right}, {0.0}}},
                        1.0);
  const double centre = 250.0;
  for (std::size_t i = 0; i < p.count(); ++i) {
    const double x = p.reals(Field::position)[i];
    if (x > left * delta) {
      p.reals(Field::density)[i] *= heavier;
      p.reals(Field::mass)[i] *= heavier;
    }
    const double v =
        std::abs(x - centre) < width ? amplitude * std::pow(std::cos(0.5 * M_PI * (x - centre) / width), 4) : 0.0;
    p.reals(Field::velocity)[i] = v;
    if (v > 0.0) p.reals(Field::density)[i] *= 1.0 + v / sound_speed;
  }
  auto simulation = simulation_of(
      fmt::format(
          "time.end = 250.0\n{}[material.light]\ndensity = 1.0\neos = {{ model = 'linear', bulk_modulus = 1.0 }}\n"
          "[material.heavy]\ndensity = {}\neos = {{ model = 'linear', bulk_modulus = {} }}\n",
          scheme, heavier, heavier),
      std::move(p));
  run_to_the_end(simulation);
  const auto x = by_id(simulation.particles(), Field::position), v = by_id(simulation.particles(), Field::velocity);
  double passed = 0.0, returned = 0.0;
  for (std::size_t i = 0; i < x.size(); ++i) {
    if (x[i] > left * delta) passed = std::max(passed, v[i]);
    if (x[i] < left * delta - 40.0) returned = std::min(returned, v[i]);
  }
  return {passed / (amplitude * 2.0 / (1.0 + heavier)),
          heavier == 1.0 ? 0.0 : returned / (amplitude * (1.0 - heavier) / (1.0 + heavier))};
}

}  // namespace

TEST_CASE("Interpenetration: bars run through each other where the shock is above all that their contact can hold") {
  for (const double factor : {0.02, 0.5})
    for (const double speed : {2000.0, 16000.0}) {
      const auto meeting = meet(with_contact(factor), speed);
      const double shock = 0.5 * density * wave_speed * speed,
                   held = largest_pressure(factor);  // acoustic, a lower bound
      WARN(fmt::format("factor {}, {} m/s: shock {:.0f} GPa, the contact holds {:.0f} GPa; part at {:.3f}: {}", factor,
                       speed, 1e-9 * shock, 1e-9 * held, meeting.apart, fmt::join(meeting.names, " ")));
      CHECK((meeting.apart > 0.5) == (shock < held));
      CHECK(meeting.names.contains("interpenetration") == (shock > held));
    }
}

TEST_CASE("Interpenetration: without viscosity nothing keeps fast Eulerian bodies apart") {
  const auto without = meet("scheme.type = 'eulerian'\n" + no_viscosity, 16000.0),
             with = meet("scheme.type = 'eulerian'\n", 16000.0);
  WARN(fmt::format("part at {:.3f} without viscosity, at {:.3f} with it", without.apart, with.apart));
  CHECK(without.apart < 0.0);
  CHECK(without.names.contains("interpenetration"));
  CHECK(with.apart > 0.5);
}

TEST_CASE(
    "Interpenetration: a total-Lagrangian bar that comes to a symmetry plane from afar needs contact with itself") {
  constexpr int length = 20;
  constexpr double speed = 200.0;
  for (const auto& [scheme, holds] : {std::pair<std::string, bool>{"scheme.type = 'total-lagrangian'\n", false},
                                      {"scheme.type = 'total-lagrangian'\ncontact.itself = true\n", true},
                                      {"scheme.type = 'eulerian'\n", true}}) {
    INFO(scheme);
    const auto end = 4.0 * length * spacing / wave_speed + 12.0 * spacing / speed;
    auto simulation = simulation_of(
        fmt::format("time.end = {}\nsymmetry.wall.axis = 'x'\n", end) + scheme + metal,
        particles_on(Space::line, {{"bar", "metal", spacing, {5.5 * spacing}, {length}, {-speed}}}, density));
    run_to_the_end(simulation);
    Watch watch;
    watch.look(simulation.particles(), simulation.settings(), simulation.scheme().warnings());
    CHECK(watch.names().contains("interpenetration") == !holds);
    CHECK((std::ranges::min(simulation.particles().reals(Field::position)) > 0.0) == holds);
  }
}

TEST_CASE("Contact: however stiff it is, the time step follows it and the energy stays") {
  for (const double factor : {0.02, 20.0, 2000.0}) {
    const auto meeting = meet(with_contact(factor), 2000.0);
    WARN(fmt::format("factor {}: part at {:.3f}, energy drift {:.1e}, {}", factor, meeting.apart, meeting.drift,
                     meeting.by_contact ? "limited by the contact" : "never limited by the contact"));
    CHECK(meeting.by_contact == (factor > 1.0));
    CHECK(std::abs(meeting.drift) < 2e-3);
    CHECK(meeting.apart > 0.85);
  }
}

TEST_CASE("Contact: a pulse that passes one is damped by first order, with or without it, and little by second") {
  // Riemann problems between unlike states are dissipation ρ c Δv: of first order in the spacing without
  // reconstruction. The same liquid behind the contact shows what the way alone takes.
  const std::string first = "scheme = { type = 'godunov-split', order = 1 }\n",
                    second = "scheme.type = 'godunov-split'\n";
  for (const auto& [scheme, least, most] : {std::tuple{first, 0.5, 0.7}, {second, 0.95, 1.06}}) {
    const auto alone = through_contact(scheme, 1.0, 1.0), contact = through_contact(scheme, 8.0, 1.0);
    WARN(fmt::format("{}{:.3f} of the pulse arrives without a contact; {:.3f} passes one of 8 : 1, {:.3f} comes back",
                     scheme, alone.passed, contact.passed, contact.returned));
    CHECK(alone.passed > least);
    CHECK(alone.passed < most);
    CHECK(contact.passed == Approx(alone.passed).epsilon(0.02));
    CHECK(contact.returned == Approx(alone.passed).epsilon(0.02));
  }
}

TEST_CASE("Contact: particles four times as far apart behind it cost what a wave of as few particles costs") {
  const std::string scheme = "scheme.type = 'godunov-split'\n";
  const auto alike = through_contact(scheme, 8.0, 1.0), wide = through_contact(scheme, 8.0, 4.0),
             wide_alone = through_contact(scheme, 1.0, 4.0);
  WARN(
      fmt::format("density 8 : 1: {:.3f} passes and {:.3f} comes back at equal spacing, {:.3f} and {:.3f} at 4 : 1; of "
                  "1 : 1 at 4 : 1 {:.3f} passes",
                  alike.passed, alike.returned, wide.passed, wide.returned, wide_alone.passed));
  CHECK(wide.passed == Approx(wide_alone.passed).epsilon(0.02));  // the density does not matter
  CHECK(wide.passed < 0.9 * alike.passed);
}
