// What a run tells of itself when it is over.
#include "output/summary.hpp"

#include <spdlog/sinks/ostream_sink.h>

#include <catch2/catch.hpp>
#include <sstream>

using namespace tektite;

TEST_CASE("Summary: a drift of the energy that matters is warned of, by name", "[summary]") {
  for (const double drift : {0.005, -0.005, 0.02, -0.02}) {
    std::ostringstream told;
    spdlog::logger log("test", std::make_shared<spdlog::sinks::ostream_sink_st>(told));
    RunSummary summary;
    summary.energy_drift = drift;
    log_summary(summary, Profile(), log);
    const bool warned = told.str().find("warning: energy-drift") != std::string::npos;
    CHECK(warned == (std::abs(drift) > 0.01));
  }
}

TEST_CASE("Summary: a drift of the angular momentum that matters is warned of, by name", "[summary]") {
  for (const std::optional<double> drift : {std::optional<double>{}, {0.005}, {0.02}}) {
    std::ostringstream told;
    spdlog::logger log("test", std::make_shared<spdlog::sinks::ostream_sink_st>(told));
    RunSummary summary;
    summary.angular_momentum_drift = drift;
    log_summary(summary, Profile(), log);
    CHECK((told.str().find("warning: spin-drift") != std::string::npos) == (drift > 0.01));
    CHECK((told.str().find("angular momentum drift") != std::string::npos) == drift.has_value());
  }
}
