// tektite run: from a scene to numbers and pictures.

#include <filesystem>
#include <optional>

#include "core/error.hpp"
#include "core/write_beside.hpp"
#include "front/commands.hpp"
#include "front/launcher.hpp"
#include "front/scene_arguments.hpp"
#include "front/stages_of_a_run.hpp"

namespace tektite::front {
namespace {

namespace fs = std::filesystem;

bool holds_a_run(const fs::path& folder) {
  return fs::exists(folder / "particles.h5") || fs::exists(folder / "snapshots");
}

/// Throws InputError where the folder of the run cannot be used. `reference` are the published values of the scene.
void check_folder(const fs::path& folder, bool replace, const std::string& reference) {
  if (fs::exists(folder) && !fs::is_directory(folder))
    throw InputError({{folder.string(), 0}, {}, {}, "this is no folder", "a folder, or a new name"});
  if (!replace && holds_a_run(folder))
    throw InputError({{folder.string(), 0},
                      {},
                      {},
                      "holds a run already",
                      "another folder by -o DIR; --replace; or `tektite resume DIR` to go on with it"});
  const auto kept = folder / reference_name;
  if (!holds_a_run(folder) && fs::exists(kept) && (reference.empty() || content_of(reference) != content_of(kept)))
    throw InputError({{kept.string(), 0},
                      {},
                      {},
                      "is there, of no run and of another scene; the published values of this one would take its place",
                      "another folder by -o DIR"});
}

/// Takes away what an earlier run left, and nothing else; last what tells that there is a run.
void clear(const fs::path& folder) {
  if (!holds_a_run(folder)) return;
  for (const auto& entry : fs::directory_iterator(folder))
    if (entry.path().extension() == ".pvd") fs::remove(entry.path());
  for (const auto* part : {"history.csv", "solve.json", "run.log", "measurements.json", "fragments.csv", "report.html",
                           "vtu", "pictures", "snapshots", "particles.h5"})
    fs::remove_all(folder / part);
}

/// The published values as the run keeps them; the scene may lie in the folder of the run.
void keep_reference(const std::string& reference, const fs::path& folder) {
  const auto kept = folder / reference_name;
  if (reference.empty()) {
    fs::remove(kept);
  } else if (!fs::exists(kept) || !fs::equivalent(reference, kept)) {
    fs::copy_file(reference, kept, fs::copy_options::overwrite_existing);
  }
}

/// The initial particles until the solver has accepted them. They are taken away again unless they were.
class Draft {
 public:
  explicit Draft(const fs::path& folder) : path_(folder / "particles.draft.h5") {}
  ~Draft() {
    std::error_code ignored;
    if (accepted_) return;
    fs::remove(path_, ignored);
    fs::remove(path_.string() + part_ending, ignored);
  }
  Draft(const Draft&) = delete;
  Draft& operator=(const Draft&) = delete;
  std::string path() const { return path_.string(); }
  /// They take the place of an earlier run. There is a run in the folder from the moment that they have their name.
  void accept(const std::string& reference) {
    const auto folder = path_.parent_path();
    clear(folder);
    keep_reference(reference, folder);
    fs::rename(path_, folder / "particles.h5");
    accepted_ = true;
  }

 private:
  fs::path path_;
  bool accepted_ = false;
};

/// What the command line of `run` says.
struct Order {
  SceneArguments scene;
  fs::path folder;
  bool replace = false;
  Words solver_options;
  Words showing_options;
};

/// Nullopt where --help or --version was all that was asked. Throws InputError.
std::optional<Order> read_order(const Words& arguments) {
  namespace po = boost::program_options;
  Order order;
  std::string output;
  int threads = 0;
  CommandLine line;
  line.usage = "tektite run SCENE.toml [--variant V] [-o DIR] [--set KEY=VALUE]... [--threads N]";
  line.about = "Fills the bodies with particles, computes the impact, measures it and draws it.";
  order.scene.add_to(line);
  line.options.add_options()("output,o", po::value(&output)->value_name("DIR"),
                             "folder of the run; else runs/NAME-VARIANT")(
      "threads", po::value(&threads)->value_name("N"),
      "threads to compute with; else all processors, if each has five hundred particles")(
      "replace", po::bool_switch(&order.replace), "replace the run that DIR holds")("no-pictures",
                                                                                    "numbers and ParaView files only");
  po::variables_map values;
  if (parse(line, arguments, values)) return std::nullopt;
  if (values.contains("threads")) order.solver_options = {"--threads", std::to_string(threads)};
  if (values.contains("no-pictures")) order.showing_options = {"--no-pictures"};
  const auto name = order.scene.run_name();
  order.folder = output.empty() ? fs::path("runs") / name : fs::path(output);
  return order;
}

}  // namespace

int run(const Words& arguments) {
  const auto order = read_order(arguments);
  if (!order) return exit_done;
  check_folder(order->folder, order->replace, order->scene.reference());

  // Wrong input is found before anything is computed, and leaves everything as it was.
  if (const int code = check_scene(Stage::postprocess, order->scene); code != exit_done) return code;
  const RunLock lock(order->folder);
  check_folder(order->folder, order->replace, order->scene.reference());  // another run may have come first
  Draft draft(order->folder);
  if (const int code = make_particles(order->scene, draft.path()); code != exit_done) return code;
  Words checking{"--check", draft.path()};
  checking.insert(checking.end(), order->solver_options.begin(), order->solver_options.end());
  if (const int code = run_stage(Stage::solve, checking); code != exit_done) return code;
  draft.accept(order->scene.reference());

  return solve_and_show(order->folder.string(), lock, order->solver_options, order->showing_options);
}

}  // namespace tektite::front
