// What ends a run before its time.
#include "run/stop_conditions.hpp"

#include <catch2/catch.hpp>

#include "support/lattice.hpp"

using namespace tektite;

namespace {

/// A projectile of four cells of 1 m with its centre at `place`, and a plate of two cells from 0 to 2 m.
Particles impact(double place, double speed, double frame = 0.0) {
  return test::particles_on(
      Space::line,
      {{"ball", "metal", 1.0, {place - 1.5}, {4}, {speed + frame}}, {"plate", "metal", 1.0, {0.5}, {2}, {frame}}}, 1.0);
}

StopCondition passage(StopCondition::Type type) { return {"stop", type, "ball", "plate", "", 0.0, 0.0}; }

bool met(const StopCondition& condition, const Particles& start, const Particles& now) {
  StopConditions stops({condition}, start, {});
  stops.look(1.0, now, {});
  return stops.met() != nullptr;
}

}  // namespace

TEST_CASE("Stop: a plate is perforated when the projectile's centre is its own length behind the rear face", "[stop]") {
  const auto condition = passage(StopCondition::Type::perforated);
  for (const double frame : {0.0, -70.0}) {
    CHECK_FALSE(met(condition, impact(-3.0, 10.0, frame), impact(5.9, 10.0)));
    CHECK(met(condition, impact(-3.0, 10.0, frame), impact(6.1, 10.0)));
  }
  // The other way round.
  CHECK_FALSE(met(condition, impact(5.0, -10.0), impact(-3.9, -10.0)));
  CHECK(met(condition, impact(5.0, -10.0), impact(-4.1, -10.0)));
}

TEST_CASE("Stop: a projectile has rebounded when it moves back and is where it struck", "[stop]") {
  const auto condition = passage(StopCondition::Type::rebounded);
  CHECK_FALSE(met(condition, impact(-3.0, 10.0), impact(-2.1, 1.0)));   // comes
  CHECK_FALSE(met(condition, impact(-3.0, 10.0), impact(-1.9, -1.0)));  // goes, and is not there yet
  CHECK(met(condition, impact(-3.0, 10.0), impact(-2.1, -1.0)));
}

TEST_CASE("Stop: steady is what has stayed near one value for so long, through a restart too", "[stop]") {
  const StopCondition condition{"stop", StopCondition::Type::steady, "", "", "b", 0.1, 2.0};
  const auto particles = impact(-3.0, 10.0);
  const std::vector<std::string> columns{"a", "b"};
  // It falls from 10 and settles at 5 from t = 4 on, swinging by less than a tenth of the largest value.
  const std::vector<double> values{10.0, 8.0, 7.0, 6.0, 5.0, 5.5, 4.5, 5.0, 5.0};
  for (const bool restarted : {false, true}) {
    StopConditions stops({condition}, particles, columns);
    double stopped = 0.0;
    for (std::size_t k = 0; k < values.size() && !stops.met(); ++k) {
      stopped = static_cast<double>(k);
      stops.look(stopped, particles, {static_cast<double>(k), values[k]});
      std::map<std::string, double> state;
      stops.save(state);
      if (restarted) stops = StopConditions({condition}, state, columns);
    }
    CHECK(stops.met());
    CHECK(stopped == 5.0);  // the 6 of t = 3 is within 1 of the values that follow, until t = 5
  }
}

TEST_CASE("Stop: a number has passed another one when it comes to it or beyond, from either side", "[stop]") {
  const auto particles = impact(-3.0, 10.0);
  const auto stopped_at = [&](const std::vector<double>& values, double value, bool restarted) {
    const StopCondition condition{"stop", StopCondition::Type::passes, "", "", "a", 0.0, 0.0, value};
    StopConditions stops({condition}, particles, {"a"});
    for (std::size_t k = 0; k < values.size(); ++k) {
      stops.look(static_cast<double>(k), particles, {values[k]});
      if (stops.met()) return static_cast<int>(k);
      std::map<std::string, double> state;
      stops.save(state);
      if (restarted) stops = StopConditions({condition}, state, {"a"});
    }
    return -1;
  };
  for (const bool restarted : {false, true}) {
    CHECK(stopped_at({-3.0, -1.0, 0.5, -2.0}, 0.0, restarted) == 2);
    CHECK(stopped_at({3.0, 2.5, 2.0, 1.0}, 2.0, restarted) == 2);
    CHECK(stopped_at({0.0, 0.0, 1.0, 2.0}, 0.0, restarted) == -1);  // goes away from where it was
    CHECK(stopped_at({0.0, 1.0, -1.0}, 0.0, restarted) == 2);
    CHECK(stopped_at({1.0, 2.0}, 3.0, restarted) == -1);
  }
}
