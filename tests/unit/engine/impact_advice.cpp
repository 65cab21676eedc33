// What tektite check says of impacts: of what the viscosity and the contact make of them, and msph.
#include <catch2/catch.hpp>

#include "advice/contact.hpp"
#include "advice/impact.hpp"
#include "advice/msph_impacts.hpp"
#include "advice/unlike_bodies.hpp"
#include "advice/viscosity.hpp"
#include "advice/weak_contacts.hpp"
#include "support/lattice.hpp"
#include "unit/engine/settings_of.hpp"

using namespace tektite;
using test::Lattice;
using test::settings_of;

TEST_CASE("Advice: artificial viscosity is named where it bears more than the flow stress", "[advice]") {
  const auto lines = [](double alpha, const std::string& strength) {
    const auto settings = settings_of(
        "space = 'plane-strain'\nviscosity.alpha = " + std::to_string(alpha) +
        "\n[material.metal]\ndensity = 2785.0\n"
        "eos = { model = 'mie-grueneisen', bulk_sound_speed = 5328.0, hugoniot_slope = 1.338, grueneisen = 2.0 }\n"
        "strength = " +
        strength + "\n[body.ball]\nmaterial = 'metal'\n[body.plate]\nmaterial = 'metal'\n[time]\nend = '10 us'\n");
    const Lattice ball{"ball", "metal", 1e-3, {-10.5e-3, -4.5e-3}, {10, 10}, {1000.0, 0.0}};
    const Lattice plate{"plate", "metal", 1e-3, {0.5e-3, -9.5e-3}, {20, 20}, {0.0, 0.0}};
    const auto particles = test::particles_on(Space::plane_strain, {ball, plate}, 2785.0);
    return viscous_strengths(particles, settings, meetings(particles, settings.materials));
  };
  const std::string plastic = "{ model = 'perfectly-plastic', shear_modulus = '27.6 GPa', yield_stress = '0.7 GPa' }";
  // 3 α ρ c h/8 · V/d with h = 1.4 mm, V = 1000 m/s and d = 10 mm: 0.779 GPa.
  CHECK(lines(1.0, plastic).size() == 2);
  CHECK(lines(1.0, plastic).front().find("0.78 GPa") != std::string::npos);
  CHECK(lines(0.85, plastic).empty());
  CHECK(lines(1.0, "{ model = 'elastic', shear_modulus = '27.6 GPa' }").empty());
}

TEST_CASE("Advice: artificial viscosity is named where a body flies at an anvil too, and not where it flies off",
          "[advice]") {
  const auto lines = [](const std::string& keep, double speed) {
    const auto settings = settings_of(
        "space = 'plane-strain'\nanvil = { axis = 'x', keep = '" + keep +
        "' }\n[material.metal]\ndensity = 2785.0\n"
        "eos = { model = 'mie-grueneisen', bulk_sound_speed = 5328.0, hugoniot_slope = 1.338, grueneisen = 2.0 }\n"
        "strength = { model = 'perfectly-plastic', shear_modulus = '27.6 GPa', yield_stress = '0.7 GPa' }\n"
        "[body.bar]\nmaterial = 'metal'\n[time]\nend = '10 us'\n");
    const double first = keep == "above" ? 0.5e-3 : -29.5e-3;
    const Lattice bar{"bar", "metal", 1e-3, {first, -4.5e-3}, {30, 10}, {speed, 0.0}};
    return viscous_strengths(test::particles_on(Space::plane_strain, {bar}, 2785.0), settings, {});
  };
  // The bar is 10 mm thick: 0.78 GPa at 1000 m/s, as above.
  REQUIRE(lines("above", -1000.0).size() == 1);
  CHECK(lines("above", -1000.0).front().find("0.78 GPa") != std::string::npos);
  CHECK(lines("below", 1000.0).size() == 1);
  CHECK(lines("above", -850.0).empty());
  CHECK(lines("above", 1000.0).empty());
}

TEST_CASE("Advice: a contact that begins in reach is named where an elastic impact is too slow for it", "[advice]") {
  const auto lines = [](double speed, const std::string& contact, const std::string& strength) {
    const auto settings = settings_of(
        "space = 'plane-strain'\nscheme.type = 'total-lagrangian'\n" + contact +
        "[material.metal]\ndensity = 2785.0\neos = { model = 'linear', bulk_modulus = '79 GPa' }\n"
        "strength = " +
        strength + "\n[body.rod]\nmaterial = 'metal'\n[body.plate]\nmaterial = 'metal'\n[time]\nend = '1 ms'\n");
    const Lattice rod{"rod", "metal", 1e-3, {-60.5e-3, -4.5e-3}, {50, 10}, {speed, 0.0}};
    const Lattice plate{"plate", "metal", 1e-3, {0.5e-3, -19.5e-3}, {80, 40}, {0.0, 0.0}};
    const auto particles = test::particles_on(Space::plane_strain, {rod, plate}, 2785.0);
    return slow_contacts(particles, settings, meetings(particles, settings.materials));
  };
  const std::string elastic = "{ model = 'elastic', shear_modulus = '27.6 GPa' }",
                    plastic = "{ model = 'perfectly-plastic', shear_modulus = '27.6 GPa', yield_stress = '0.3 GPa' }",
                    reach = "contact.model = 'kernel-penalty'\n";
  // The way is 2 h - δ = 1.8 mm, and waves take 15.5 µs through 50 mm and back: too slow below 116 m/s.
  REQUIRE(lines(110.0, reach, elastic).size() == 1);
  CHECK(lines(110.0, reach, elastic).front().find("at-faces") != std::string::npos);
  CHECK(lines(120.0, reach, elastic).empty());
  CHECK(lines(110.0, "contact.begins = 'at-faces'\n", elastic).empty());
  // ρ c V/2 is 0.3 GPa at 33 m/s: above, the metal flows.
  CHECK(lines(30.0, reach, plastic).size() == 1);
  CHECK(lines(37.0, reach, plastic).empty());
}

TEST_CASE("Advice: an impact of more pressure than its contact bears", "[advice]") {
  using Catch::Matchers::Contains;
  const auto lines = [](double speed, const std::string& contact, const std::string& left) {
    const auto settings = settings_of("space = 'line'\nscheme.type = 'total-lagrangian'\n" + contact +
                                      "[material.metal]\ndensity = 2785.0\neos = { model = 'linear', bulk_modulus = "
                                      "'79 GPa' }\n[material.left]\ndensity = 1000.0\neos = " +
                                      left + "\n[body.left]\nmaterial = 'left'\n[body.right]\nmaterial = 'metal'\n" +
                                      "[time]\nend = '10 us'\n");
    const auto particles = test::particles_on(
        Space::line, {{"left", "left", 1e-3, {-40e-3}, {40}, {speed}}, {"right", "metal", 1e-3, {3e-3}, {40}, {0.0}}},
        1000.0);
    return weak_contacts(particles, settings, meetings(particles, settings.materials));
  };
  const std::string usual = "contact.model = 'kernel-penalty'\n", stiff = "contact.factor = 0.1\n",
                    metal = "{ model = 'linear', bulk_modulus = '79 GPa' }",
                    water = "{ model = 'stiffened-gas', bulk_sound_speed = 1500.0, grueneisen = 4.0 }",
                    gas = "{ model = 'ideal-gas', heat_ratio = 1.4 }";
  CHECK(lines(2000.0, usual, metal).empty());
  REQUIRE(lines(16000.0, usual, metal).size() == 1);
  CHECK_THAT(lines(16000.0, usual, metal).front(), Contains("at most 34") && Contains("contact.factor = 0.02"));
  // Water is 35 times as soft: 1 GPa, where the impact has 2.4 GPa.
  CHECK(lines(100.0, usual, water).empty());
  REQUIRE(lines(1000.0, usual, water).size() == 1);
  CHECK_THAT(lines(1000.0, usual, water).front(), Contains("holds them"));
  CHECK(lines(1000.0, stiff, water).empty());
  CHECK(lines(1000.0, "", water).empty());
  REQUIRE(lines(1000.0, usual, gas).size() == 1);
  CHECK_THAT(lines(1000.0, usual, gas).front(), Contains("run through each other"));
}

TEST_CASE("Advice: kernel sums that join a light body to one too stiff for the step", "[advice]") {
  using Catch::Matchers::Contains;
  const auto lines = [](const std::string& scheme, const std::string& left) {
    const auto settings = settings_of(
        "space = 'line'\n" + scheme +
        "[material.steel]\ndensity = 7850.0\neos = { model = 'linear', bulk_modulus = '160 GPa' }\n"
        "strength = { model = 'elastic', shear_modulus = '80 GPa' }\n[material.left]\n" +
        left + "\n[body.left]\nmaterial = 'left'\n[body.right]\nmaterial = 'steel'\n" + "[time]\nend = '10 us'\n");
    const auto particles = test::particles_on(
        Space::line, {{"left", "left", 1e-3, {-40e-3}, {40}, {50.0}}, {"right", "steel", 1e-3, {3e-3}, {40}, {0.0}}},
        1000.0);
    return unlike_bodies(particles, settings, meetings(particles, settings.materials));
  };
  const std::string foam = "density = 100.0\neos = { model = 'linear', bulk_modulus = '0.2 GPa' }",
                    resin = "density = 1200.0\neos = { model = 'linear', bulk_modulus = '6 GPa' }",
                    gas = "density = 1.2\neos = { model = 'ideal-gas', heat_ratio = 1.4 }";
  // √(7850/100) = 8.9 times the wave speed of steel, with C = 0.25.
  REQUIRE(lines("", foam).size() == 1);
  CHECK_THAT(lines("", foam).front(), Contains("2.2 times") && Contains("scheme.courant = 0.11"));
  CHECK(lines("scheme.courant = 0.11\n", foam).empty());
  CHECK(lines("contact.begins = 'at-faces'\n", foam).empty());
  CHECK(lines("scheme.type = 'godunov-pm'\n", foam).empty());
  CHECK(lines("", resin).empty());
  CHECK(lines("", gas).size() == 1);
}

TEST_CASE("Advice: elastic impacts of total-Lagrangian bodies whose zero-energy modes nothing holds", "[advice]") {
  const auto lines = [](const std::string& scheme, const std::string& strength) {
    const auto settings = settings_of("space = 'plane-strain'\n" + scheme +
                                      "[material.metal]\ndensity = 2785.0\n"
                                      "eos = { model = 'linear', bulk_modulus = '79 GPa' }\nstrength = " +
                                      strength +
                                      "\n[body.ball]\nmaterial = 'metal'\n[body.plate]\nmaterial = 'metal'\n"
                                      "[time]\nend = '10 us'\n");
    const Lattice ball{"ball", "metal", 1e-3, {-10.5e-3, -4.5e-3}, {10, 10}, {100.0, 0.0}};
    const Lattice plate{"plate", "metal", 1e-3, {0.5e-3, -9.5e-3}, {20, 20}, {0.0, 0.0}};
    const auto particles = test::particles_on(Space::plane_strain, {ball, plate}, 2785.0);
    return rough_contacts(particles, settings, meetings(particles, settings.materials)).size();
  };
  const std::string elastic = "{ model = 'elastic', shear_modulus = '27.6 GPa' }",
                    plastic = "{ model = 'perfectly-plastic', shear_modulus = '27.6 GPa', yield_stress = '0.3 GPa' }",
                    contact = "contact.model = 'kernel-penalty'\n";
  CHECK(lines(contact + "scheme.type = 'total-lagrangian'\n", elastic) == 1);
  CHECK(lines(contact + "scheme.type = 'total-lagrangian'\n", plastic) == 0);
  CHECK(lines(contact + "scheme = { type = 'total-lagrangian', hourglass_control = 0.05 }\n", elastic) == 0);
  CHECK(lines(contact + "scheme.type = 'eulerian'\n", elastic) == 0);
}

TEST_CASE("Advice: how far the energy of an impact by msph is off, by the forces and the particles", "[advice]") {
  const auto lines = [](const std::string& scheme, double spacing, int across) {
    const auto settings = settings_of(
        "space = 'plane-strain'\nsmoothing = { kernel = 'truncated-gaussian', ratio = 1.5 }\nscheme = { " + scheme +
        " }\n[material.metal]\ndensity = 2785.0\neos = { model = 'linear', bulk_modulus = '79 GPa' }\n"
        "[body.rod]\nmaterial = 'metal'\n[body.plate]\nmaterial = 'metal'\n[time]\nend = '1 us'\n");
    const Lattice rod{"rod", "metal", spacing, {-40.0 * spacing, 0.0}, {30, across}, {2000.0, 0.0}};
    const Lattice plate{"plate", "metal", 1e-3, {0.5e-3, -19.5e-3}, {20, 40}, {0.0, 0.0}};
    const auto particles = test::particles_on(Space::plane_strain, {rod, plate}, 2785.0);
    return msph_impacts(particles, settings, meetings(particles, settings.materials));
  };
  const auto says = [&](const std::vector<std::string>& found, const std::string& words) {
    return found.size() == 1 && found.front().find(words) != std::string::npos;
  };
  const std::string strong = "type = 'msph'", adjoint = "type = 'msph', forces = 'adjoint'";
  CHECK(says(lines(strong, 1e-3, 10), "10 particles through the thinner one and spacings of 1 to 1: "));
  CHECK(says(lines(strong, 1e-3, 1), ", 1 particle through the thinner one"));
  CHECK(says(lines(strong, 1e-3, 10), "off by up to 10 %"));
  CHECK(says(lines(strong, 0.25e-3, 10), "off by up to 15 % of the energy, and by 2 % with scheme.forces"));
  CHECK(says(lines(strong, 1e-3, 1), "off by up to 152 %"));
  CHECK(says(lines(adjoint, 1e-3, 1), "off by up to 7 % of the energy, and 5 of 90 ended in an error"));
  CHECK(says(lines(strong, 1e-3, 1), "2 of 90"));
  CHECK_FALSE(says(lines(strong, 1e-3, 10), "of 90"));
  CHECK(lines(adjoint, 0.25e-3, 10).empty());
  CHECK(lines("type = 'eulerian'", 1e-3, 1).empty());
}
