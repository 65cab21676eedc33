// What the solver reads of a scene, and whether the particles are those of it.
#include "run/run_settings.hpp"

#include <catch2/catch.hpp>

#include "support/fault.hpp"
#include "support/lattice.hpp"

using namespace tektite;
using Catch::Matchers::Contains;

namespace {

const std::string head = "name = 'test'\nspace = 'line'\ntime.end = 1.0\n";
const std::string metal = "[material.metal]\ndensity = 1.0\neos = { model = 'linear', bulk_modulus = 1.0 }\n";

RunSettings settings_of(const std::string& scene) {
  auto document = Document::parse(scene, "scene.toml");
  return read_run_settings(document);
}

Particles particles_in(Space space, const std::string& material) {
  const auto d = static_cast<std::size_t>(dimensions_of(space));
  return test::particles_on(
      space, {{"bar", material, 1.0, std::vector<double>(d, 0.0), std::vector<int>(d, 2), std::vector<double>(d, 0.0)}},
      1.0);
}

}  // namespace

TEST_CASE("Run settings: a scene without a material is refused", "[settings]") {
  CHECK_THAT(test::fault_of([] { settings_of(head); }),
             Contains("the scene has no material (allowed: [material.NAME])"));
}

TEST_CASE("Run settings: a body of a material that the scene does not have is refused with those that it has",
          "[settings]") {
  CHECK(test::fault_of([] { settings_of(head + metal + "[body.bar]\nmaterial = 'glass'\n"); }) ==
        "scene.toml:8: body.bar.material = \"glass\": there is no such material (allowed: metal)");
}

TEST_CASE("Run settings: a run that counts from a contact which never comes ends, and says so", "[settings]") {
  const auto apart = [](double gap) {
    return test::particles_on(
        Space::line, {{"left", "metal", 1.0, {0.0}, {10}, {1.0}}, {"right", "metal", 1.0, {9.0 + gap}, {10}, {1.0}}},
        1.0);
  };
  const auto run = [&](double gap) {
    auto simulation = test::simulation_of(
        "time = { end = 10.0, from = 'contact' }\n[body.left]\nmaterial = 'metal'\n[body.right]\nmaterial = 'metal'\n" +
            metal,
        apart(gap));
    test::run_to_the_end(simulation);
  };
  CHECK_NOTHROW(run(1.0));
  CHECK_THROWS_WITH(run(20.0),
                    Contains("the run counts from the first contact of two bodies (time.from), but none has"));
}

TEST_CASE("Run settings: a scheme that none has read from a scene is an error of the program", "[settings]") {
  auto settings = settings_of(head + metal);
  auto particles = particles_in(Space::line, "metal");
  Profile profile;
  settings.scheme.type = "finite-elements";
  CHECK_THROWS_WITH(make_scheme({particles, profile, settings.materials, settings.scheme, {}}),
                    "read_scheme() lets no unknown scheme through");
}

TEST_CASE("Run settings: particles of another space or material than the scene's are refused with both", "[settings]") {
  const auto settings = settings_of(head + metal);
  const auto check = [&](Space space, const std::string& material) {
    check_bodies(settings, particles_in(space, material), "particles.h5");
  };
  CHECK_NOTHROW(check(Space::line, "metal"));
  CHECK(test::fault_of([&] { check(Space::plane_strain, "metal"); }) ==
        "particles.h5: /@space = plane-strain: the particles live in another space than the scene (allowed: line)");
  CHECK(test::fault_of([&] { check(Space::line, "glass"); }) ==
        "particles.h5: /bodies/bar = glass: the scene has no such material (allowed: metal)");
}

TEST_CASE("Run settings: the shortest end is not refused for its tenth, which output.snapshots is left out",
          "[settings]") {
  const auto settings = settings_of("name = 'test'\nspace = 'line'\ntime.end = 1e-30\n" + metal);
  CHECK(settings.snapshot_interval == settings.end);
}

TEST_CASE("Run settings: a history every 7.0 steps is shown as it was written", "[settings]") {
  CHECK_THAT(test::fault_of([] { settings_of(head + "output.history = 7.0\n" + metal); }),
             Contains("output.history = 7.0: not a whole number"));
}

TEST_CASE("Run settings: adaptle has no velocities that a viscosity could reconstruct for both kinds of particles",
          "[settings]") {
  CHECK_THAT(
      test::fault_of([] {
        settings_of(head + "scheme = { type = 'adaptle', conversion = 'none' }\nviscosity.model = 'limited'\n" + metal);
      }),
      Contains("viscosity.model = \"limited\"") && Contains("allowed: monaghan"));
}
