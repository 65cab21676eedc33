// Many particles: ten million in space take the memory that tektite check forecasts, and postprocess takes less of it
// than a snapshot of theirs has bytes.
#include <algorithm>
#include <catch2/catch.hpp>
#include <filesystem>
#include <fstream>
#include <iostream>
#include <regex>
#include <string>

#include "core/snapshot.hpp"
#include "robustness/small_run.hpp"

namespace {

using namespace tektite;
using namespace tektite::test;

/// Two blocks of 108 x 216 x 216 particles meet, a hundred steps long.
constexpr const char* blocks = R"(name = 'load'
space = 'solid'
spacing = '0.1 mm'

[material.aluminium]
density = '2785 kg/m3'
eos = { model = 'stiffened-gas', bulk_sound_speed = '5328 m/s', grueneisen = 2.0 }
strength = { model = 'perfectly-plastic', shear_modulus = '27.6 GPa', yield_stress = '0.3 GPa' }

[body.left]
material = 'aluminium'
shape = { type = 'box', lower = ['-10.8 mm', 0, 0], upper = [0, '21.6 mm', '21.6 mm'] }
velocity = ['1 km/s', 0, 0]

[body.right]
material = 'aluminium'
shape = { type = 'box', lower = [0, 0, 0], upper = ['10.8 mm', '21.6 mm', '21.6 mm'] }

[time]
end = '0.5 us'

[output]
snapshots = '1 us'
)";

/// The number of the first match.
double number_in(const std::string& text, const std::string& pattern) {
  std::smatch match;
  if (!std::regex_search(text, match, std::regex(pattern))) throw std::runtime_error("no " + pattern + " in " + text);
  return std::stod(match[1]);
}

TEST_CASE("Load: a hundred steps of ten million particles in the memory that was forecast", "[.long]") {
  const TemporaryFolder folder;
  std::ofstream(folder.file("scene.toml")) << blocks;
  const auto done = [&](const std::vector<std::string>& words) {
    const auto outcome = run_in(folder.path(), words);
    INFO(outcome.output << outcome.faults);
    REQUIRE(outcome.code == 0);
    return outcome.output;
  };
  done({stage_program("preprocess"), "scene.toml", "-o", "particles.h5"});
  const double forecast =
      1e9 * number_in(done({stage_program("solve"), "--check", "particles.h5"}), "memory ([0-9.]+) GB");
  done({stage_program("solve"), "."});
  const auto summary = content_of(folder.file("solve.json"));
  const double came = number_in(summary, "\"peak_memory_bytes\": ([0-9]+)");
  const double steps = number_in(summary, "\"steps\": ([0-9]+)");
  std::cout << "load: " << number_in(summary, "\"particles\": ([0-9]+)") << " particles, " << steps << " steps, "
            << forecast << " bytes forecast, " << came << " came, " << number_in(summary, "\"wall_seconds\": ([0-9.]+)")
            << " s\n";
  CHECK(steps >= 100);
  CHECK(came < 1.1 * forecast);  // the forecast's own limit
  CHECK(came > 0.9 * forecast);
}

/// A square lattice of 1024 particles along a side, with every field that a file may have.
Snapshot plate_with_every_field() {
  constexpr std::size_t along = 1024, count = along * along;
  constexpr double spacing = 1e-3;
  Snapshot snapshot{Particles(Space::plane_strain, {{"plate", "aluminium", spacing, {0, count}}}),
                    {{"time", 1e-6}},
                    "name = 'plate'\nspace = 'plane-strain'\n[body.plate]\n[measure.max_pressure]\nbody = 'plate'\n"};
  auto& particles = snapshot.particles;
  for (const auto field : saved_fields()) {
    particles.allocate(field);
    if (info(field).rank != Rank::integer) std::ranges::fill(particles.reals(field), 1.4 * spacing);
  }
  for (std::size_t i = 0; i < count; ++i) {
    particles.integers(Field::id)[i] = static_cast<std::int64_t>(i);
    particles.vectors<2>(Field::position)[i] = {spacing * static_cast<double>(i % along),
                                                spacing * static_cast<double>(i / along)};
  }
  return snapshot;
}

TEST_CASE("Load: postprocess takes less memory than one snapshot of many particles has bytes") {
  const TemporaryFolder folder;
  write_snapshot(plate_with_every_field(), folder.file("snapshots/000001.h5"));
  const auto kilobytes = std::filesystem::file_size(folder.file("snapshots/000001.h5")) / 1024;
  const auto outcome = run_in(folder.path(), {"/bin/sh", "-c",
                                              "ulimit -d " + std::to_string(kilobytes) + "; exec " +
                                                  stage_program("postprocess") + " . --no-pictures"});
  INFO(outcome.output << outcome.faults);
  CHECK(outcome.code == 0);
  CHECK_THAT(outcome.output, Catch::Contains("max_pressure"));
  CHECK(std::filesystem::exists(folder.file("vtu/000001/0001.vtu")));
}

}  // namespace
