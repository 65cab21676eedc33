#pragma once

#include <chrono>
#include <cstdint>
#include <string>

namespace tektite {

/// The line that shows how a run goes on; silent where standard error is no terminal.
class Progress {
 public:
  struct Now {
    std::int64_t step = 0;
    double time = 0.0;
    double end = 0.0;  ///< infinite while it is not known
    double dt = 0.0;
    const char* reason = "";
    double drift = 0.0;
    std::size_t particles = 0;
  };

  Progress();
  /// Draws at most a few times a second.
  void show(const Now& now);
  /// Wipes the line before something else is printed.
  void clear();

 private:
  using Clock = std::chrono::steady_clock;
  bool terminal_;
  bool drawn_ = false;
  Clock::time_point start_ = Clock::now();
  Clock::time_point last_ = start_;
  std::int64_t first_step_ = -1;
  double first_time_ = 0.0;
};

/// "8.0 µs", with three significant digits.
std::string shown_time(double seconds);

/// "1:02:03"
std::string shown_clock(double seconds);

}  // namespace tektite
