// What probes show: the particles that were nearest to their place, wherever they go, or the extremes of a body.
#include "output/probes.hpp"

#include <algorithm>
#include <catch2/catch.hpp>

#include "support/fault.hpp"
#include "support/lattice.hpp"

using namespace tektite;

namespace {

Particles two_bodies() {
  auto p = test::particles_on(
      Space::line, {{"near", "metal", 1.0, {0.0}, {4}, {0.0}}, {"far", "metal", 1.0, {100.0}, {4}, {0.0}}}, 1.0);
  p.allocate(Field::pressure);
  for (std::size_t i = 0; i < p.count(); ++i) p.reals(Field::pressure)[i] = i % 2 == 0 ? -1.0 * i : 1.0 * i;
  return p;
}

}  // namespace

TEST_CASE("Probes: a place shows its particle, an extreme the least and the largest of its own body", "[probes]") {
  const auto p = two_bodies();  // pressures 0 1 -2 3 and -4 5 -6 7
  Probes probes({{"place", "near", Shown::particle, {1.9}, {Field::pressure}},
                 {"lowest", "near", Shown::least, {}, {Field::pressure}},
                 {"highest", "far", Shown::largest, {}, {Field::pressure}}},
                p);
  CHECK(probes.columns(p) == std::vector<std::string>{"place.pressure", "lowest.pressure", "highest.pressure"});
  CHECK(probes.values(p) == std::vector<double>{-2.0, -2.0, 7.0});
}

TEST_CASE("Probes: where particles tie for nearest, the mean over them is shown, mirrored, shifted or neither",
          "[probes]") {
  const double spacing = GENERATE(1.0, 1e-3);
  const double shift = GENERATE(0.0, 1000.0);
  const double sign = GENERATE(1.0, -1.0);
  const double first = sign * (0.3 * spacing) + (sign < 0.0 ? -3.0 * spacing : 0.0) + shift;
  auto p = test::particles_on(Space::line, {{"bar", "metal", spacing, {first}, {4}, {0.0}}}, 1.0);
  p.allocate(Field::pressure);
  const std::vector<double> pressure{1.0, 10.0, 100.0, 1000.0};
  for (std::size_t i = 0; i < 4; ++i) p.reals(Field::pressure)[i] = pressure[sign > 0.0 ? i : 3 - i];
  const auto at = [&](double spacings) { return sign * (0.3 + spacings) * spacing + shift; };
  Probes probes({{"between", "bar", Shown::particle, {at(1.5)}, {Field::pressure}},
                 {"nearer", "bar", Shown::particle, {at(1.4999)}, {Field::pressure}}},
                p);
  CHECK(probes.values(p) == std::vector<double>{55.0, 10.0});
}

TEST_CASE("Probes: particles that tie are followed after a restart, wherever they are sorted to", "[probes]") {
  auto p = two_bodies();  // at 0 1 2 3, with the pressures 0 1 -2 3
  const std::vector<Probe> wanted{{"between", "near", Shown::particle, {1.5}, {Field::pressure}},
                                  {"place", "near", Shown::particle, {3.2}, {Field::pressure}}};
  std::map<std::string, double> state;
  Probes started(wanted, p);
  CHECK(started.values(p) == std::vector<double>{-0.5, 3.0});
  started.save(state);
  for (const auto field : {Field::position, Field::pressure}) std::ranges::reverse(p.reals(field).first(4));
  std::ranges::reverse(p.integers(Field::id).first(4));
  CHECK(Probes(wanted, state).values(p) == std::vector<double>{-0.5, 3.0});
}

TEST_CASE("Probes: what each follows is told, with the distance from its place", "[probes]") {
  const auto p = two_bodies();
  Probes probes({{"between", "near", Shown::particle, {1.5}, {Field::pressure}},
                 {"place", "near", Shown::particle, {3.25}, {Field::pressure}},
                 {"lowest", "near", Shown::least, {}, {Field::pressure}}},
                p);
  CHECK(probes.in_words(p) ==
        std::vector<std::string>{"probe between: the mean of particles 1, 2, 0.5 m from its place",
                                 "probe place: particle 3, 0.25 m from its place"});
}

TEST_CASE("Probes: extremes go on after a restart", "[probes]") {
  const auto p = two_bodies();
  const std::vector<Probe> wanted{{"lowest", "far", Shown::least, {}, {Field::pressure}}};
  std::map<std::string, double> state;
  Probes(wanted, p).save(state);
  CHECK(Probes(wanted, state).values(p) == std::vector<double>{-6.0});
}

TEST_CASE("Probes: extremes of a vector are those of each component", "[probes]") {
  const auto p =
      test::particles_on(Space::plane_strain, {{"body", "metal", 1.0, {2.0, -3.0}, {4, 3}, {0.0, 0.0}}}, 1.0);
  Probes probes(
      {{"low", "body", Shown::least, {}, {Field::position}}, {"high", "body", Shown::largest, {}, {Field::position}}},
      p);
  CHECK(probes.columns(p) ==
        std::vector<std::string>{"low.position_x", "low.position_y", "high.position_x", "high.position_y"});
  CHECK(probes.values(p) == std::vector<double>{2.0, -3.0, 5.0, -1.0});
}

TEST_CASE("Probes: a body, a probe or a particle that is not there is named", "[probes]") {
  using Catch::Matchers::Contains;
  const auto p = two_bodies();
  const std::vector<Probe> elsewhere{{"there", "nowhere", Shown::particle, {0.0}, {Field::pressure}}};
  CHECK_THAT(test::fault_of([&] { Probes(elsewhere, p); }), Contains("probe.there") && Contains("no such body"));
  const std::vector<Probe> wanted{{"place", "near", Shown::particle, {1.9}, {Field::pressure}}};
  CHECK_THROWS_WITH(Probes(wanted, std::map<std::string, double>{}), "/state/@probe.place");
  Probes gone(wanted, {{"probe.place", 99.0}});
  CHECK_THROWS_WITH(gone.values(p), Contains("probe place: its particle 99 is gone"));
}
