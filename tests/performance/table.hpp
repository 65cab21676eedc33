#pragma once
// The table of README.md: what each case did, and which part of what the machine can do at most that is.

#include <benchmark/benchmark.h>
#include <fmt/format.h>

#include <map>
#include <string>
#include <vector>

namespace tektite {

inline constexpr const char* multiplications = "machine/multiply and add";
inline constexpr const char* memory = "machine/stream";

/// Prints what Google Benchmark prints, and keeps the medians, or single runs where there are no repetitions.
class Table : public benchmark::ConsoleReporter {
 public:
  void ReportRuns(const std::vector<Run>& runs) override {
    benchmark::ConsoleReporter::ReportRuns(runs);
    for (const auto& run : runs) {
      if (run.run_type == Run::RT_Aggregate && run.aggregate_name != "median") continue;
      const auto name = run.run_name.function_name;
      if (!cases_.contains(name)) order_.push_back(name);
      auto& counters = cases_[name][run.run_name.args];
      for (const auto& [counter, value] : run.counters) counters[counter] = value.value;
    }
  }

  void print() const {
    const double most = one(multiplications, "", "operations_per_second"), stream = one(memory, "", "bytes_per_second");
    fmt::print("\n{:.0f} thousand million operations and {:.0f} GB a second at most on one core\n\n", 1e-9 * most,
               1e-9 * stream);
    fmt::print(
        "| case | particles | neighbours | per core | two threads over one | bytes | of the stream | operations | "
        "of the peak |\n|---|---|---|---|---|---|---|---|---|\n");
    for (const auto& name : order_) {
      if (name.starts_with("machine/")) continue;
      const double per_core = one(name, "threads:1", "per_core"), bytes = one(name, "threads:1", "bytes_per_particle");
      const double operations = one(name, "threads:1", "operations");
      const auto counted = operations == 0.0
                               ? std::string("| |")
                               : fmt::format("{:.0f} | {:.0f} % |", operations, 100.0 * per_core * operations / most);
      fmt::print("| {} | {:.0f} | {:.0f} | {:.2f} | {:.2f} | {:.0f} | {:.0f} % | {}\n", name,
                 one(name, "threads:1", "particles"), one(name, "threads:1", "neighbours"), 1e-6 * per_core,
                 one(name, "threads:2", "items_per_second") / one(name, "threads:1", "items_per_second"), bytes,
                 100.0 * per_core * bytes / stream, counted);
    }
  }

 private:
  double one(const std::string& name, const std::string& threads, const std::string& counter) const {
    const auto found = cases_.find(name);
    if (found == cases_.end()) return 0.0;
    const auto of_threads = found->second.find(threads);
    if (of_threads == found->second.end()) return 0.0;
    const auto value = of_threads->second.find(counter);
    return value == of_threads->second.end() ? 0.0 : value->second;
  }

  std::vector<std::string> order_;
  std::map<std::string, std::map<std::string, std::map<std::string, double>>> cases_;
};

}  // namespace tektite
