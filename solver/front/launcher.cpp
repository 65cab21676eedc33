#include "front/launcher.hpp"

#include <fmt/format.h>

#include <fstream>
#include <iterator>
#include <sstream>

#include "core/program.hpp"
#include "core/system_words.hpp"

namespace tektite::front {

namespace fs = std::filesystem;

RunFiles::RunFiles(const fs::path& folder, const std::string& name)
    : run(folder / "runs" / name),
      log(run.string() + ".log"),
      faults(run.string() + ".faults"),
      failure(run.string() + ".failed"),
      scene(run.string() + ".scene.toml"),
      task(run.string() + ".task"),
      end(run.string() + ".ended") {}

void RunFiles::clear() const {
  for (const auto& file : {scene, failure, task, end}) fs::remove(file);
  fs::remove_all(run);
}

std::string content_of(const fs::path& path) {
  std::ifstream file(path, std::ios::binary);
  return {std::istreambuf_iterator<char>(file), {}};
}

std::string failure_of(const RunFiles& files, int code) {
  if (code == exit_done) return {};
  if (code < 0) return fmt::format("ended by signal {} ({})", -code, words_for_signal(-code));
  std::istringstream lines(content_of(files.faults));
  const std::string mark = ": error: ";
  for (std::string line; std::getline(lines, line);)
    if (const auto at = line.find(mark); at != std::string::npos) return line.substr(at + mark.size());
  return fmt::format("ended with exit code {}", code);
}

}  // namespace tektite::front
