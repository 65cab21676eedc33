#include "run/run.hpp"

#include <fmt/format.h>

#include <atomic>
#include <csignal>
#include <filesystem>
#include <optional>

#include "core/run_lock.hpp"
#include "core/saved_number.hpp"
#include "core/snapshot_files.hpp"
#include "output/progress.hpp"
#include "parallel/agreed.hpp"
#include "parallel/snapshot_on_ranks.hpp"
#include "parallel/threads.hpp"
#include "run/floating_point_traps.hpp"
#include "run/recorded_run.hpp"
#include "run/set_up.hpp"

namespace tektite {
namespace {

namespace fs = std::filesystem;

std::atomic<bool> interrupted = false;

/// A launcher sends the signals to every rank: the first one tells the others.
void watch_signals() {
  interrupted = false;
  struct sigaction action {};
  if (rank() == 0)
    action.sa_handler = [](int) { interrupted = true; };
  else
    action.sa_handler = SIG_IGN;
  sigaction(SIGINT, &action, nullptr);
  sigaction(SIGTERM, &action, nullptr);
}

/// Throws InputError where there is nothing to resume.
Origin find_origin(const RunOptions& options) {
  const fs::path folder(options.folder);
  const auto particles = (folder / "particles.h5").string();
  if (!options.resume) return {particles, false};
  if (const auto snapshots = snapshot_files(folder); !snapshots.empty()) return {snapshots.back(), true};
  if (fs::exists(particles)) return {particles, false};
  throw InputError(
      {{options.folder, 0}, {}, {}, "there is no snapshot to go on from", "the folder of a run that was started"});
}

/// Throws InputError where the run is beyond its new end already.
void check_end(const Simulation& simulation, const RunOptions& options) {
  if (simulation.time() > simulation.end())
    throw InputError({{"--end " + options.end, 0},
                      {},
                      {},
                      fmt::format("the newest snapshot is at t = {}", shown_time(simulation.time())),
                      "a later time"});
}

/// What an earlier run has left in its folder, and what a killed one has left unfinished.
void clear(const RunOptions& options, const Origin& origin) {
  remove_parts_of_snapshots(options.folder);
  if (!origin.snapshot)
    for (const auto& earlier : snapshot_files(options.folder)) fs::remove(earlier);
}

bool compute(const RunOptions& options, const Origin& origin) {
  auto snapshot = read_snapshot_on_ranks(origin.file);
  use_threads(options.threads, count_of_all(snapshot.particles) / static_cast<std::size_t>(ranks()));
  auto document = scene_of(snapshot, origin.file);
  if (!options.end.empty()) document.set("time.end=" + options.end, "--end " + options.end);
  auto settings = settings_of(snapshot, origin.file, document);
  snapshot.scene = document.text();
  if (rank() == 0) clear(options, origin);
  watch_signals();
  if (options.trap_floating_point) trap_floating_point();
  const RunTimer timer;
  try {
    auto simulation = simulation_of(std::move(snapshot), std::move(settings), origin.snapshot, document);
    check_probed_fields(document, simulation.settings(), simulation.particles());
    if (!options.end.empty()) check_end(simulation, options);
    RecordedRun run(options.folder, origin, timer, simulation, !options.end.empty(),
                    [] { return from_first_rank({interrupted ? Word{1} : Word{0}}).front() != 0; });
    const bool over = run.to_the_end();
    dismiss_ranks();
    return over;
  } catch (const MissingNumber& missing) {
    throw InputError({{origin.file, 0}, missing.what(), {}, "is missing", "a snapshot of this scene, whole"});
  }
}

/// What the first rank has found: a file, and behind it whether it is a snapshot.
Origin origin_of_all(const Origin& own) {
  Words words{own.snapshot ? Word{1} : Word{0}};
  words.insert(words.end(), own.file.begin(), own.file.end());
  words = from_first_rank(words);
  return {std::string(words.begin() + 1, words.end()), words.front() != 0};
}

}  // namespace

bool run(const RunOptions& options) {
  if (rank() > 0) return compute(options, origin_of_all({}));
  if (!fs::is_directory(options.folder))
    throw InputError({{options.folder, 0}, {}, {}, "there is no such folder", "the folder of a run"});
  const auto lock = options.lock < 0 ? std::make_unique<RunLock>(options.folder)
                                     : std::make_unique<RunLock>(options.folder, options.lock);
  return compute(options, origin_of_all(find_origin(options)));
}

}  // namespace tektite
