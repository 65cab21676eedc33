// tektite run: from a scene to numbers and pictures.

#include <filesystem>
#include <optional>

#include "core/error.hpp"
#include "front/commands.hpp"
#include "front/scene_arguments.hpp"
#include "front/stages_of_a_run.hpp"

namespace tektite::front {
namespace {

namespace fs = std::filesystem;

/// Throws InputError where the folder of the run cannot be used.
void check_folder(const fs::path& folder, bool replace) {
  if (fs::exists(folder) && !fs::is_directory(folder))
    throw InputError({{folder.string(), 0}, {}, {}, "this is no folder", "a folder, or a new name"});
  if (!replace && (fs::exists(folder / "particles.h5") || fs::exists(folder / "snapshots")))
    throw InputError({{folder.string(), 0},
                      {},
                      {},
                      "holds a run already",
                      "another folder by -o DIR; --replace; or `tektite resume DIR` to go on with it"});
}

/// Takes away what an earlier run left, and nothing else.
void clear(const fs::path& folder) {
  for (const auto* part : {"particles.h5", "snapshots", "history.csv", "solve.json", "run.log", "measurements.json",
                           "fragments.csv", "vtu", "pictures", reference_name})
    fs::remove_all(folder / part);
  for (const auto& entry : fs::directory_iterator(folder))
    if (entry.path().extension() == ".pvd") fs::remove(entry.path());
}

/// The initial particles until the solver has accepted them. They are taken away again, and with them a folder that was
/// made for them, unless they were accepted.
class Draft {
 public:
  explicit Draft(const fs::path& folder)
      : path_(folder / "particles.draft.h5"),
        accepted_path_(folder / "particles.h5"),
        new_folder_(!fs::exists(folder)) {}
  ~Draft() {
    std::error_code ignored;
    if (accepted_) return;
    fs::remove(path_, ignored);
    if (new_folder_) fs::remove(path_.parent_path(), ignored);
  }
  Draft(const Draft&) = delete;
  Draft& operator=(const Draft&) = delete;
  std::string path() const { return path_.string(); }
  void accept() {
    clear(path_.parent_path());
    fs::rename(path_, accepted_path_);
    accepted_ = true;
  }

 private:
  fs::path path_;
  fs::path accepted_path_;
  bool new_folder_;
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
      "threads", po::value(&threads)->value_name("N"), "threads to compute with; else all processors")(
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
  check_folder(order->folder, order->replace);

  // Wrong input is found before anything is computed, and leaves everything as it was.
  if (const int code = check_scene(Stage::postprocess, order->scene); code != exit_done) return code;
  Draft draft(order->folder);
  if (const int code = make_particles(order->scene, draft.path()); code != exit_done) return code;
  if (const int code = run_stage(Stage::solve, {"--check", draft.path()}); code != exit_done) return code;
  draft.accept();

  if (const auto reference = order->scene.reference(); !reference.empty())
    fs::copy_file(reference, order->folder / reference_name);
  return solve_and_show(order->folder.string(), order->solver_options, order->showing_options);
}

}  // namespace tektite::front
