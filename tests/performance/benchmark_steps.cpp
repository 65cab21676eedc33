// Whole steps of a scheme on particles from a file: benchmark_steps FILE.h5... [options of Google Benchmark]
//
// FILE is an initial state or a snapshot in the middle of a run. Every iteration takes ten steps, on one thread and on
// two; items are particle-steps per second of real time, and those per second of processor time and thread stand beside
// them, which other programs on the machine disturb less. What the machine can do at most is measured first; a table of
// all that ends the output.

#include <benchmark/benchmark.h>

#include <ctime>
#include <filesystem>
#include <iostream>

#include "core/program.hpp"
#include "machine_limits.hpp"
#include "neighbours.hpp"
#include "pair_operations.hpp"
#include "parallel/threads.hpp"
#include "run/simulation.hpp"
#include "table.hpp"

namespace {

using namespace tektite;

Simulation load(const std::string& file) {
  auto snapshot = read_snapshot(file);
  auto document = Document::parse(snapshot.scene, file + ":/scene");
  auto settings = read_run_settings(document);
  const bool resumed = snapshot.state.contains("step");
  return Simulation(std::move(snapshot), std::move(settings), resumed);
}

void take_steps(benchmark::State& state, const std::string& file) {
  constexpr int steps = 10;
  use_threads(static_cast<int>(state.range(0)));
  auto simulation = load(file);
  const double neighbours = mean_neighbours(simulation.particles());
  const std::clock_t start = std::clock();
  for (auto _ : state)
    for (int k = 0; k < steps; ++k) simulation.step();
  const double processor_seconds = static_cast<double>(std::clock() - start) / CLOCKS_PER_SEC;
  const auto particles = simulation.particles().count();
  state.SetItemsProcessed(state.iterations() * steps * static_cast<std::int64_t>(particles));
  state.counters["per_core"] = static_cast<double>(state.items_processed()) / processor_seconds;
  state.counters["particles"] = static_cast<double>(particles);
  state.counters["neighbours"] = neighbours;
  state.counters["operations"] = neighbours * pair_operations(simulation.settings());
  state.counters["bytes_per_particle"] =
      static_cast<double>(simulation.particles().memory() + simulation.scheme().memory()) /
      static_cast<double>(particles);
}

}  // namespace

int main(int argc, char** argv) {
  wait_briefly(argv);
  benchmark::Initialize(&argc, argv);
  return run_program("benchmark_steps", [&] {
    if (argc < 2) throw InputError("no particle file is named");
    benchmark::RegisterBenchmark(multiplications, multiply_and_add);
    benchmark::RegisterBenchmark(memory, stream);
    for (int k = 1; k < argc; ++k) {
      const std::string file = argv[k];
      const auto name = std::filesystem::path(file).parent_path().filename().string() + "/" +
                        std::filesystem::path(file).stem().string();
      benchmark::RegisterBenchmark(name.c_str(), take_steps, file)
          ->ArgName("threads")
          ->Arg(1)
          ->Arg(2)
          ->UseRealTime()
          ->Unit(benchmark::kMillisecond);
    }
    Table table;
    benchmark::RunSpecifiedBenchmarks(&table);
    table.print();
    return int{exit_done};
  });
}
