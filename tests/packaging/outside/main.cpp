// outside PARTICLES.h5 END.h5: computes a run by the library and compares its end, bit for bit, with END.h5, which
// tektite-solve has left.
#include <core/snapshot.hpp>
#include <run/simulation.hpp>

#include <algorithm>
#include <cstdio>
#include <utility>

int main(int argc, char** argv) {
  if (argc != 3) return 2;
  auto snapshot = tektite::read_snapshot(argv[1]);
  auto document = tektite::Document::parse(snapshot.scene, argv[1]);
  auto settings = tektite::read_run_settings(document);
  tektite::Simulation simulation(std::move(snapshot), std::move(settings), false);
  while (!simulation.finished()) simulation.step();

  const auto end = tektite::read_snapshot(argv[2]);
  bool same = simulation.particles().count() == end.particles.count();
  for (const auto field : {tektite::Field::position, tektite::Field::velocity})
    same = same && std::ranges::equal(simulation.particles().reals(field), end.particles.reals(field));
  std::printf("%lld steps, %s\n", static_cast<long long>(simulation.steps()), same ? "the same end" : "another end");
  return same ? 0 : 1;
}
