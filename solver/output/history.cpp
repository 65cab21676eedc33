#include "output/history.hpp"

#include <fmt/format.h>
#include <fmt/os.h>

#include <algorithm>
#include <charconv>

#include "core/error.hpp"
#include "run/angular_momentum.hpp"

namespace tektite {
namespace {

InputError no_history(const std::string& path, const std::string& reason) {
  return InputError({{path, 0},
                     {},
                     {},
                     reason,
                     "the history of this run, whole; or `tektite run SCENE.toml -o DIR --replace`, from the start"});
}

/// The history's lines up to a step, the header included.
std::string kept_lines(const std::string& path, std::int64_t last_step, std::int64_t interval) {
  std::ifstream old(path);
  if (!old) throw no_history(path, "there is none that can be read, and the run cannot be resumed without");
  std::string line, kept;
  std::int64_t reached = -1;
  for (bool header = true; std::getline(old, line); header = false) {
    std::int64_t step = -1;
    const auto read = std::from_chars(line.data(), line.data() + line.size(), step);
    if (!header && (read.ec != std::errc{} || step > last_step || old.eof())) break;
    reached = std::max(reached, step);
    kept += line + '\n';
  }
  if (reached < 0) throw no_history(path, "holds no step");
  if (reached < last_step - last_step % interval)
    throw no_history(path,
                     fmt::format("the history ends at step {}, before the snapshot of step {}", reached, last_step));
  return kept;
}

}  // namespace

History::History(const std::string& path, const std::vector<std::string>& number_columns) : path_(path) {
  std::string header = "step,time,dt,dt_reason,dt_particle";
  for (const auto& column : number_columns) header += "," + column;
  write_text_beside(path, header + '\n');
  file_.open(path, std::ios::app);
}

History::History(const std::string& path, std::int64_t last_step, std::int64_t interval) : path_(path) {
  write_text_beside(path, kept_lines(path, last_step, interval));
  file_.open(path, std::ios::app);
}

void History::write(const Row& row) {
  auto line = fmt::format("{},{},{},{},{}", row.step, row.time, row.dt, row.reason, row.limiting_particle);
  for (const double number : row.numbers) line += fmt::format(",{}", number);
  file_ << line << '\n' << std::flush;
  if (!file_) throw RunError(path_ + ": cannot be written (is the disk full?)");
}

std::vector<std::string> number_columns(Space space, const std::vector<std::string>& probe_columns) {
  std::vector<std::string> names{"kinetic_energy", "internal_energy",  "plastic_work", "viscous_work",
                                 "contact_energy", "hourglass_energy", "total_energy"};
  for (int k = 0; k < dimensions_of(space); ++k) names.push_back(fmt::format("momentum_{}", "xyz"[k]));
  for (const int axis : axes_of_turning(space)) names.push_back(fmt::format("angular_momentum_{}", "xyz"[axis]));
  names.insert(names.end(), probe_columns.begin(), probe_columns.end());
  return names;
}

std::vector<double> numbers_of(const Ledger& ledger, const std::vector<double>& angular_momentum,
                               const std::vector<double>& probes) {
  std::vector<double> numbers{ledger.kinetic, ledger.internal,  ledger.plastic, ledger.viscous,
                              ledger.contact, ledger.hourglass, ledger.total()};
  numbers.insert(numbers.end(), ledger.momentum.begin(), ledger.momentum.end());
  numbers.insert(numbers.end(), angular_momentum.begin(), angular_momentum.end());
  numbers.insert(numbers.end(), probes.begin(), probes.end());
  return numbers;
}

}  // namespace tektite
