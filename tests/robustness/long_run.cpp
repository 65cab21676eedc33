// A run of a million steps takes no more memory than one of a thousand.
#include <algorithm>
#include <catch2/catch.hpp>
#include <iostream>
#include <string>

#include "support/program.hpp"

namespace {

using namespace tektite::test;

/// A bar that rings: ten particles in a line, 1.04 µs a step.
constexpr const char* ringing_bar = R"(name = 'bar'
space = 'line'
spacing = '20 mm'
smoothing.ratio = 2.0

[material.aluminium]
density = '2785 kg/m3'
eos = { model = 'linear', bulk_modulus = '79 GPa' }
strength = { model = 'elastic', shear_modulus = '27.6 GPa' }

[body.bar]
material = 'aluminium'
shape = { type = 'segment', lower = 0, upper = '0.2 m' }
velocity = { type = 'pulse', speed = '0.1 m/s', centre = '0.1 m', width = '0.1 m' }

[output]
history = 1000
)";

/// A whole number of solve.json.
long number_in(const std::string& json, const std::string& key) {
  const auto at = json.find('"' + key + "\": ");
  if (at == std::string::npos) throw std::runtime_error("solve.json has no " + key);
  return std::stol(json.substr(at + key.size() + 4));
}

/// What the solver says of a run that ends then.
std::string run_until(const std::string& end) {
  const TemporaryFolder folder;
  std::ofstream(folder.file("scene.toml")) << ringing_bar << "[time]\nend = '" << end << "'\n";
  const auto program = std::string(TEKTITE_PROGRAM);
  REQUIRE(run_in(folder.path(), {program + "-preprocess", "scene.toml", "-o", "particles.h5"}).code == 0);
  const auto outcome = run_in(folder.path(), {program + "-solve", ".", "--threads", "1"});
  INFO(outcome.faults);
  REQUIRE(outcome.code == 0);
  return content_of(folder.file("solve.json"));
}

TEST_CASE("Long run: a million steps take no more memory than a thousand", "[.long]") {
  const auto brief = run_until("1.1 ms"), extended = run_until("1.1 s");
  const auto steps = number_in(extended, "steps");
  const auto before = number_in(brief, "peak_memory_bytes"), after = number_in(extended, "peak_memory_bytes");
  std::cout << "long run: " << number_in(brief, "steps") << " steps, " << before << " bytes; " << steps << " steps, "
            << after << " bytes\n";
  CHECK(steps > 1'000'000);
  CHECK(after < before + steps);  // not a byte a step
}

}  // namespace
