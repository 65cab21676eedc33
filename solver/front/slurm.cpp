#include "front/slurm.hpp"

#include <fmt/format.h>
#include <sys/wait.h>

#include <algorithm>
#include <array>
#include <sstream>
#include <string_view>

#include "core/error.hpp"
#include "core/program.hpp"
#include "core/wait_for.hpp"
#include "core/write_beside.hpp"

namespace tektite::front {
namespace {

namespace fs = std::filesystem;

/// States in which a task has ended; every other one, a future one too, counts as in hand, so that none runs twice.
constexpr std::array<std::string_view, 10> ended_states{"BOOT_FAIL", "CANCELLED", "COMPLETED",     "DEADLINE",
                                                        "FAILED",    "NODE_FAIL", "OUT_OF_MEMORY", "PREEMPTED",
                                                        "REVOKED",   "TIMEOUT"};

/// Variables that would have squeue leave out tasks.
constexpr std::array hiding{"SQUEUE_ACCOUNT", "SQUEUE_LICENSES", "SQUEUE_NAMES", "SQUEUE_PARTITION", "SQUEUE_QOS"};

/// A word as the shell takes it.
std::string quoted(const std::string& word) {
  std::string text = "'";
  for (const char character : word) text += character == '\'' ? "'\\''" : std::string(1, character);
  return text + "'";
}

}  // namespace

std::string script_of(const std::vector<const Job*>& jobs, const fs::path& job_file) {
  std::string text = "#!/bin/sh\n# Written by tektite chart: each task is a run.\ncase $SLURM_ARRAY_TASK_ID in\n";
  const auto program = fs::read_symlink("/proc/self/exe").string();
  for (std::size_t k = 0; k < jobs.size(); ++k) {
    text += fmt::format("{}) run={}; set -- {}", k, quoted(jobs[k]->files.run), quoted(program));
    for (const auto& word : jobs[k]->arguments) text += ' ' + quoted(word);
    text += " ;;\n";
  }
  return text + fmt::format(R"(esac
left=60
until grep -qsx -e "$SLURM_ARRAY_JOB_ID" -e "$SLURM_ARRAY_JOB_ID;.*" {0}; do
  [ $((left -= 1)) -gt 0 ] || exit 1
  sleep 1
done
told=
trap 'told=yes' TERM
"$@" >"$run.log" 2>"$run.faults"
code=$?
[ -z "$told" ] || [ "$code" -eq 0 ] || exit "$code"
[ "$code" -lt 128 ] || exit "$code"
echo "$code" >"$run.ended{1}" && mv "$run.ended{1}" "$run.ended"
exit "$code"
)",
                            quoted(job_file), part_ending);
}

bool in_hand(const Queue& queue, const std::string& job, int index) {
  const auto found = queue.find({job, index});
  return found != queue.end() && std::ranges::find(ended_states, found->second) == ended_states.end();
}

std::string Slurm::job(int number) const {
  const auto said = content_of(job_file(number));
  return said.substr(0, said.find_first_not_of("0123456789"));
}

int Slurm::next_number() const {
  int number = 1;
  while (fs::exists(script(number))) ++number;
  return number;
}

void Slurm::submit(int number, const Words& options) const {
  Words words{"sbatch"};
  words.insert(words.end(), options.begin(), options.end());
  words.insert(words.end(), {"--parsable", script(number).string()});
  if (call(words, job_file(number), held_back_) == exit_done && !job(number).empty()) return;
  const auto reason = last_words();
  throw RunError("sbatch has submitted nothing: " + (reason.empty() ? "it names no job" : reason));
}

void Slurm::withdraw(int number) const {
  fs::remove(job_file(number));
  fs::remove(script(number));
}

std::optional<Queue> Slurm::queue() const {
  const auto file = folder_ / "queue";
  Words words{"env"};
  for (const std::string variable : hiding) words.push_back("--unset=" + variable);
  words.insert(words.end(), {"squeue", "--me", "--array", "--states=all", "--noheader", "--format=%F %K %T"});
  if (call(words, file, let_through_) != exit_done) return std::nullopt;
  Queue queue;
  std::istringstream lines(content_of(file));
  for (std::string line; std::getline(lines, line);) {
    std::istringstream cells(line);
    std::string job, state;
    int index = 0;
    if (cells >> job >> index >> state) queue[{job, index}] = state;  // jobs that are no array have no index
  }
  return queue;
}

std::string Slurm::last_words() const {
  std::string all;
  std::istringstream lines(content_of(faults()));
  for (std::string line; std::getline(lines, line);) {
    for (const std::string mark : {": error: ", ": fatal: "})
      if (const auto at = line.find(mark); at != std::string::npos) line.erase(0, at + mark.size());
    all += (all.empty() ? "" : "; ") + line;
  }
  return all;
}

int Slurm::call(const Words& words, const fs::path& output, const sigset_t& mask) const {
  const pid_t child = spawn(words.front(), {words.begin() + 1, words.end()}, {output, faults()}, mask);
  const int status = wait_for(child, words.front());
  return WIFEXITED(status) ? WEXITSTATUS(status) : exit_failed;
}

}  // namespace tektite::front
