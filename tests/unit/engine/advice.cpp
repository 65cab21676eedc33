// What tektite check finds in a scene: symmetry, thickness, what waves reach, and the pressure of an impact.
#include <catch2/catch.hpp>

#include "advice/advise.hpp"
#include "advice/forecast.hpp"
#include "advice/impact.hpp"
#include "advice/plausibility.hpp"
#include "advice/reach.hpp"
#include "advice/symmetry.hpp"
#include "advice/thickness.hpp"
#include "output/progress.hpp"
#include "run/locking.hpp"
#include "support/lattice.hpp"
#include "unit/engine/settings_of.hpp"

using namespace tektite;

namespace {

using test::Lattice;
using test::settings_of;

/// A ball of this radius in spacings before a plate of 4 x 24 x 24 cells, both centred about the x axis.
Particles ball_and_plate(double offset = 0.0, double sideways = 0.0) {
  auto ball = test::ball(3, 1.0, 3.5);
  ball.body = "ball";
  ball.first = {-8.0, -3.5 + offset, -3.5};
  ball.inside = [offset](const double* x) { return std::hypot(x[0] + 4.5, x[1] - offset, x[2]) <= 3.5; };
  ball.velocity = {1000.0, sideways, 0.0};
  return test::particles_on(
      Space::solid, {ball, Lattice{"plate", "metal", 1.0, {0.5, -11.5, -11.5}, {4, 24, 24}, {0.0, 0.0, 0.0}}}, 1.0);
}

std::vector<int> axes_of(const std::vector<SymmetryPlane>& planes) {
  std::vector<int> axes;
  for (const auto& plane : planes) axes.push_back(plane.axis);
  return axes;
}

}  // namespace

TEST_CASE("Advice: mirrors are found where particles and velocities are mirrored, and only there", "[advice]") {
  CHECK(axes_of(unused_mirrors(ball_and_plate(), {})) == std::vector<int>{1, 2});
  CHECK(axes_of(unused_mirrors(ball_and_plate(), {{1, 0.0, 1.0}})) == std::vector<int>{2});
  CHECK(axes_of(unused_mirrors(ball_and_plate(1.0), {})) == std::vector<int>{2});
  CHECK(axes_of(unused_mirrors(ball_and_plate(0.0, 10.0), {})) == std::vector<int>{2});
  for (const auto& plane : unused_mirrors(ball_and_plate(), {})) CHECK(plane.at == Approx(0.0).margin(1e-12));
  auto clamped = ball_and_plate();
  clamped.allocate(Field::clamped);
  clamped.integers(Field::clamped).back() = 1;  // a corner
  CHECK(unused_mirrors(clamped, {}).empty());
}

TEST_CASE("Advice: bodies of revolution are found about their axis, and a square plate is none", "[advice]") {
  const auto lines_of = [](const Particles& particles) { return unused_revolutions(particles, {}); };
  CHECK(lines_of(ball_and_plate()).empty());
  const auto round = [](const double* x) { return std::hypot(x[1], x[2]) <= 12.0; };
  Lattice rod{"rod", "metal", 1.0, {-9.5, -11.5, -11.5}, {20, 24, 24}, {300.0, 0.0, 0.0}, round};
  const auto rods = test::particles_on(Space::solid, {rod}, 1.0);
  const auto found = lines_of(rods);
  REQUIRE(found.size() == 1);
  CHECK(found.front().axis == 0);
  CHECK(found.front().section_particles == Approx(20.0 * 12.0).epsilon(0.1));
  rod.velocity = {300.0, 10.0, 0.0};
  CHECK(lines_of(test::particles_on(Space::solid, {rod}, 1.0)).empty());
  auto ball = test::ball(2, 1.0, 10.0);
  auto disc = test::particles_on(Space::plane_strain, {ball}, 1.0);
  CHECK(lines_of(disc).size() == 1);
  INFO("what spins is not the same in a space about an axis");
  for (std::size_t i = 0; i < disc.count(); ++i) {
    const auto x = disc.vectors<2>(Field::position)[i];
    disc.vectors<2>(Field::velocity)[i] = {-10.0 * x[1], 10.0 * x[0]};
  }
  CHECK(lines_of(disc).empty());
}

TEST_CASE("Advice: particles through a plate, a tilted row's end and a plate behind a symmetry plane", "[advice]") {
  const auto particles = ball_and_plate();
  const auto through = [&](const std::vector<SymmetryPlane>& planes) {
    return particles_through(particles, particles.bodies()[1], planes);
  };
  CHECK(through({}) == 4.0);
  CHECK(through({{0, 4.0, -1.0}}) == 8.0);  // the plate ends half a spacing before it
  CHECK(through({{0, 9.0, -1.0}}) == 4.0);
  const double ball = particles_through(particles, particles.bodies()[0], {});
  CHECK(ball >= 4.0);  // seven across its middle, fewer beside it
  CHECK(ball <= 7.0);
}

TEST_CASE("Advice: bodies that come nearer and pass each other by do not meet, and are told", "[advice]") {
  const auto settings = settings_of(
      "space = 'plane-strain'\n[material.metal]\ndensity = 2785.0\n"
      "eos = { model = 'linear', bulk_modulus = '79 GPa' }\n[body.ball]\nmaterial = 'metal'\n"
      "[body.plate]\nmaterial = 'metal'\n[time]\nend = '10 us'\n");
  // A plate of 20 mm x 20 mm whose lower edge lies at y = 0; the ball flies with its upper edge at -`below`.
  const auto past = [&](double below, const std::vector<double>& velocity) {
    const Lattice ball{"ball", "metal", 1e-3, {-50e-3, -below - 9e-3}, {10, 10}, velocity};
    const Lattice plate{"plate", "metal", 1e-3, {0.0, 0.0}, {20, 20}, {0.0, 0.0}};
    const auto particles = test::particles_on(Space::plane_strain, {ball, plate}, 2785.0);
    return std::pair{meetings(particles, settings.materials).size(), misses(particles).size()};
  };
  // The kernel reaches 2.8 mm.
  CHECK(past(2.0e-3, {1000.0, 0.0}) == std::pair<std::size_t, std::size_t>{1, 0});
  CHECK(past(3.0e-3, {1000.0, 0.0}) == std::pair<std::size_t, std::size_t>{0, 1});
  CHECK(past(30e-3, {1000.0, 500.0}) == std::pair<std::size_t, std::size_t>{1, 0});
  CHECK(past(30e-3, {1000.0, -10.0}) == std::pair<std::size_t, std::size_t>{0, 1});
  CHECK(past(30e-3, {1000.0, 2000.0}) == std::pair<std::size_t, std::size_t>{0, 1});
  CHECK(past(30e-3, {-1000.0, 0.0}) == std::pair<std::size_t, std::size_t>{0, 0});
}

TEST_CASE("Advice: bodies that meet when the run has ended, or never come nearer, are told", "[advice]") {
  using Catch::Matchers::Contains;
  const auto settings = settings_of(
      "space = 'plane-strain'\n[material.metal]\ndensity = 2785.0\n"
      "eos = { model = 'linear', bulk_modulus = '79 GPa' }\n[body.ball]\nmaterial = 'metal'\n"
      "[body.plate]\nmaterial = 'metal'\n[time]\nend = '10 us'\n");
  // 50 mm between them, of which the kernels reach over 2.8 mm: 47.2 µs at 1 km/s.
  const auto flying = [](double speed) {
    const Lattice ball{"ball", "metal", 1e-3, {-59e-3, 5e-3}, {10, 10}, {speed, 0.0}};
    const Lattice plate{"plate", "metal", 1e-3, {0.0, 0.0}, {20, 20}, {0.0, 0.0}};
    return test::particles_on(Space::plane_strain, {ball, plate}, 2785.0);
  };
  const auto towards = flying(1000.0), away = flying(-1000.0);
  const auto met = meetings(towards, settings.materials);
  REQUIRE(met.size() == 1);
  CHECK(met.front().arrival == Approx(47.2e-6).epsilon(1e-6));
  const auto early = in_words(met, 40e-6), late = in_words(met, 50e-6);
  REQUIRE(early.size() == 1);
  CHECK_THAT(early.front(), Contains("ball meets plate after 47.2 µs at the earliest") && Contains("nothing has met"));
  CHECK_THAT(late.front(), Contains("ball meets plate at 1000 m/s") && Contains("by Hugoniot matching"));
  CHECK(strangers(towards).empty());
  CHECK(strangers(away).size() == 1);
  const auto touching = test::particles_on(Space::plane_strain,
                                           {{"left", "metal", 1e-3, {-9e-3, 0.0}, {9, 9}, {-10.0, 0.0}},
                                            {"right", "metal", 1e-3, {0.0, 0.0}, {9, 9}, {0.0, 0.0}}},
                                           2785.0);
  CHECK(strangers(touching).empty());
}

TEST_CASE("Advice: a density or a wave speed that no material has is told, as of a wrong unit", "[advice]") {
  using Catch::Matchers::Contains;
  const auto lines = [](const std::string& density, const std::string& modulus) {
    return implausible(settings_of("space = 'plane-strain'\n[material.metal]\ndensity = " + density +
                                   "\neos = { model = 'linear', bulk_modulus = " + modulus +
                                   " }\n[body.ball]\nmaterial = 'metal'\n[time]\nend = '1 us'\n")
                           .materials);
  };
  CHECK(lines("2785.0", "'79 GPa'").empty());
  CHECK(lines("22590.0", "'462 GPa'").empty());  // osmium
  CHECK(lines("3515.0", "'1211 GPa'").empty());  // diamond, with the modulus of its fastest wave
  REQUIRE(lines("2.785", "'79 GPa'").size() == 1);
  CHECK_THAT(lines("2.785", "'79 GPa'").front(),
             Contains("metal") && Contains("1.684e+05 m/s") && Contains("2.785 kg/m3"));
  REQUIRE(lines("2785e3", "'79 GPa'").size() == 1);
  CHECK_THAT(lines("2785e3", "'79 GPa'").front(), Contains("osmium"));
}

TEST_CASE("Advice: an end that no run would come to is told, and its forecast is one of years", "[advice]") {
  using Catch::Matchers::Contains;
  const std::vector<Lattice> bodies{{"a", "metal", 1e-3, {0.0, 0.0}, {20, 10}, {0.0, 0.0}}};
  const auto scene = [](const std::string& end) {
    return "time.end = " + end +
           "\n[material.metal]\ndensity = 2785.0\neos = { model = 'linear', bulk_modulus = '79 GPa' }\n";
  };
  const auto lines = [&](const std::string& end) {
    return implausible_end(test::particles_on(Space::plane_strain, bodies, 2785.0),
                           settings_of("space = 'plane-strain'\n" + scene(end)));
  };
  CHECK(lines("'8 us'").empty());
  CHECK(lines("'300 ms'").empty());
  REQUIRE(lines("8").size() == 1);
  CHECK_THAT(lines("8").front(), Contains("3.6e-06 s") && Contains("time.end = 8 s"));

  auto simulation = test::simulation_of(scene("1e25"), test::particles_on(Space::plane_strain, bodies, 2785.0));
  const auto forecast = forecast_of(simulation, {}, 0.0);
  CHECK(forecast.steps > 1e31);  // of some 60 ns
  CHECK(forecast.disk_bytes > 1e33);
  CHECK_THAT(shown_clock(8e30), Contains("years"));
  CHECK(shown_clock(3599.5) == "1:00:00");
}

TEST_CASE("Advice: many lines of one kind do not hide those of another, nor say the same of a body twice", "[advice]") {
  std::string scene =
      "name = 'test'\nspace = 'plane-strain'\n[material.metal]\ndensity = 2785.0\n"
      "eos = { model = 'linear', bulk_modulus = '79 GPa' }\n[time]\nend = '40 us'\n";
  // A ball that meets three of forty blocks and passes the others by.
  std::vector<Lattice> bodies;
  for (int k = 0; k < 40; ++k)
    bodies.push_back({"block" + std::to_string(k), "metal", 1e-3, {0.0, 6e-3 * k}, {6, 6}, {0.0, 0.0}});
  bodies.push_back({"ball", "metal", 1e-3, {-20e-3, 3e-3}, {9, 9}, {1000.0, 0.0}});
  for (const auto& body : bodies) scene += "[body." + body.body + "]\nmaterial = 'metal'\nshape.type = 'disc'\n";
  auto document = Document::parse(scene, "test scene");
  const auto settings = read_run_settings(document);
  const auto particles = test::particles_on(Space::plane_strain, bodies, 2785.0);
  const auto advice = advise(particles, settings, meetings(particles, settings.materials), document);
  const auto count = [&](const std::string& words) {
    return std::ranges::count_if(advice.lines, [&](const auto& line) { return line.find(words) != std::string::npos; });
  };
  CHECK(count("meets ball at") == 3);
  CHECK(count("ball: compressed by") == 1);
  CHECK(count("pass each other") == 8);
  CHECK(count("and 29 more of this kind") == 1);
  CHECK(count("particles through the thinnest part") == 1);
}

TEST_CASE("Advice: only spaces are named that know the strength of the bodies", "[advice]") {
  using Catch::Matchers::Contains;
  const auto said = [](int dimensions, const std::string& strength) {
    const std::string scene = std::string("space = '") + (dimensions == 2 ? "plane-strain" : "solid") +
                              "'\nscheme.type = 'eulerian'\n[material.metal]\ndensity = 1.0\n"
                              "eos = { model = 'linear', bulk_modulus = '79 GPa' }\n" +
                              strength + "[body.ball]\nmaterial = 'metal'\n[time]\nend = '10 us'\n";
    auto document = Document::parse("name = 'test'\n" + scene, "test scene");
    const auto settings = read_run_settings(document);
    const auto particles = test::particles_on(dimensions == 2 ? Space::plane_strain : Space::solid,
                                              {test::ball(dimensions, 1.0, 10.0)}, 1.0);
    std::string lines;
    for (const auto& line : advise(particles, settings, {}, document).lines) lines += line + "\n";
    return lines;
  };
  const std::string strong = "strength = { model = 'elastic', shear_modulus = '27 GPa' }\n";
  CHECK_THAT(said(3, ""), Contains("the space spherical would do, by msph or ssph"));
  CHECK_THAT(said(3, strong), Contains("the space axisymmetric would need") && !Contains("spherical"));
  CHECK_THAT(said(2, ""), Contains("the space cylindrical would need") && Contains("by msph or ssph"));
  CHECK_THAT(said(2, strong), !Contains("cylindrical"));
}

TEST_CASE("Advice: Strang's splitting is named where a body has strength", "[advice]") {
  using Catch::Matchers::Contains;
  const auto said = [](const std::string& splitting, const std::string& strength) {
    auto document =
        Document::parse("name = 'test'\nspace = 'line'\nscheme = { type = 'godunov-split', splitting = '" + splitting +
                            "' }\n[material.metal]\ndensity = 1.0\n"
                            "eos = { model = 'linear', bulk_modulus = '79 GPa' }\n" +
                            strength + "[body.bar]\nmaterial = 'metal'\n[time]\nend = '10 us'\n",
                        "test scene");
    const auto settings = read_run_settings(document);
    const auto bar = test::particles_on(Space::line, {{"bar", "metal", 1.0, {0.0}, {20}, {0.0}}}, 1.0);
    std::string lines;
    for (const auto& line : advise(bar, settings, {}, document).lines) lines += line + "\n";
    return lines;
  };
  const std::string strong = "strength = { model = 'elastic', shear_modulus = '27 GPa' }\n";
  CHECK_THAT(said("strang", strong), Contains("scheme.splitting = 'strang'") && Contains("lie-trotter"));
  CHECK_THAT(said("strang", ""), !Contains("splitting"));
  CHECK_THAT(said("lie-trotter", strong), !Contains("splitting"));
}

TEST_CASE("Advice: what locks where it bends is told before the run, with both moduli", "[advice]") {
  using Catch::Matchers::Contains;
  const auto material = [](double shear) {
    return settings_of(
               "space = 'line'\n[material.metal]\ndensity = 2785.0\n"
               "eos = { model = 'linear', bulk_modulus = '79 GPa' }\n"
               "strength = { model = 'elastic', shear_modulus = " +
               std::to_string(shear) + " }\n[body.bar]\nmaterial = 'metal'\n[time]\nend = '10 us'\n")
        .materials.at("metal");
  };
  CHECK_FALSE(locking("bar", material(27e9)));
  const auto rubbery = locking("bar", material(0.9e9));
  REQUIRE(rubbery);
  CHECK_THAT(*rubbery, Contains("0.4943") && Contains("79 GPa") && Contains("0.9 GPa"));
  INFO("a modulus in GPa without its unit");
  CHECK(locking("bar", material(27.6)));
}

TEST_CASE("Advice: what waves do not reach is found, with room for the fastest of them", "[advice]") {
  const std::string scene =
      "space = 'plane-strain'\n[material.metal]\ndensity = 2785.0\n"
      "eos = { model = 'mie-grueneisen', bulk_sound_speed = 5328.0, hugoniot_slope = 1.338, grueneisen = 2.0 }\n"
      "strength = { model = 'elastic', shear_modulus = '27.6 GPa' }\n[body.ball]\nmaterial = 'metal'\n"
      "[body.plate]\nmaterial = 'metal'\n[time]\nend = '10 us'\n";
  const double d = 1e-3;
  const Lattice ball{"ball", "metal", d, {-10.5 * d, -4.5 * d}, {10, 10}, {1000.0, 0.0}};
  const Lattice plate{"plate", "metal", d, {0.5 * d, -199.5 * d}, {20, 400}, {0.0, 0.0}};
  const auto particles = test::particles_on(Space::plane_strain, {ball, plate}, 2785.0);
  const auto settings = settings_of(scene);
  const auto met = meetings(particles, settings.materials);
  REQUIRE(met.size() == 1);
  const auto trims = unreached(particles, settings, met);
  REQUIRE(trims.size() == 1);
  CHECK(trims[0].body->name == "plate");
  // 10 µs at c_l = 6450 m/s, faster than the shock of 6000 m/s, beyond the ball's edge, and the kernel.
  const double c = wave_speed_at_rest(settings.materials.at("metal"));
  CHECK(c == Approx(6450.0).epsilon(0.01));
  const double reach = c * 10e-6 + 2.8 * d + 4.5 * d;
  CHECK(trims[0].upper[1] == Approx(reach).margin(2 * d));
  CHECK(trims[0].lower[1] == Approx(-reach).margin(2 * d));
  CHECK(trims[0].upper[0] - trims[0].lower[0] == Approx(20 * d));
  // A plate that does something by itself is left alone.
  auto stirred = particles;
  stirred.reals(Field::velocity).back() = 1.0;
  CHECK(unreached(stirred, settings, meetings(stirred, settings.materials)).empty());
  auto pressed = particles;  // everywhere alike: it will expand from all its surfaces
  const auto& range = pressed.bodies().back().range;
  for (auto i = range.begin; i < range.end; ++i) pressed.reals(Field::density)[i] *= 1.01;
  CHECK(unreached(pressed, settings, meetings(pressed, settings.materials)).empty());
}
