// tektite-solve --trap-floating-point: the first number that is not finite ends the run where it comes from.
#include <catch2/catch.hpp>
#include <filesystem>
#include <fstream>
#include <string>

#include "robustness/small_run.hpp"

namespace {

using namespace tektite::test;
using Catch::Matchers::Contains;

/// A plate, part of which starts denser than a shock can make its metal, where the sound speed is not real.
constexpr const char* squeezed = R"(name = 'squeezed'
space = 'line'
spacing = '1 mm'

[material.metal]
density = '2785 kg/m3'
eos = { model = 'mie-grueneisen', bulk_sound_speed = '5328 m/s', hugoniot_slope = 1.5, grueneisen = 2.0 }

[body.plate]
material = 'metal'
shape = { type = 'segment', lower = 0, upper = '10 mm' }
region.dense = { shape = { type = 'segment', lower = 0, upper = '2 mm' }, density = '9000 kg/m3' }

[time]
end = '1 us'
)";

TEST_CASE("Floating-point traps: the run ends at the first undefined number and says where it came from") {
  const TemporaryFolder folder;
  std::ofstream(folder.file("scene.toml")) << squeezed;
  const auto filled = run_in(folder.path(), {stage_program("preprocess"), "scene.toml", "-o", "particles.h5"});
  INFO(filled.faults);
  REQUIRE(filled.code == 0);
  const auto untrapped = run_in(folder.path(), {stage_program("solve"), ".", "--threads", "1"});
  INFO(untrapped.faults);
  CHECK(untrapped.code == 1);
  CHECK_THAT(untrapped.faults, Contains("the state is no longer sane"));
  const auto trapped = run_in(folder.path(), {stage_program("solve"), ".", "--trap-floating-point", "--threads", "1"});
  INFO(trapped.faults);
  CHECK(trapped.code == 1);
  CHECK_THAT(trapped.faults, Contains("tektite-solve: error: ") && Contains("of floating-point numbers; where") &&
                                 Contains("tektite-solve("));
}

}  // namespace
