#include "output/progress.hpp"

#include <fmt/format.h>
#include <unistd.h>

#include <array>
#include <cmath>
#include <cstdio>

namespace tektite {

Progress::Progress() : terminal_(::isatty(STDERR_FILENO) == 1) {}

void Progress::show(const Now& now) {
  if (!terminal_) return;
  if (first_step_ < 0) {
    first_step_ = now.step - 1;
    first_time_ = now.time - now.dt;
  }
  const auto clock = Clock::now();
  constexpr auto pause = std::chrono::milliseconds(200);
  if (clock - last_ < pause) return;
  last_ = clock;
  const double wall = std::chrono::duration<double>(clock - start_).count();
  const double rate = static_cast<double>(now.step - first_step_) * static_cast<double>(now.particles) / wall;
  std::string done = "waiting for contact";
  if (std::isfinite(now.end)) {
    const double part = now.time / now.end;
    const double remaining = wall * (now.end - now.time) / (now.time - first_time_);
    done = fmt::format("{} of {} ({:.0f} %), {} left", shown_time(now.time), shown_time(now.end), 100.0 * part,
                       shown_clock(remaining));
  }
  const auto line = fmt::format("\r\033[Kstep {}  {}  dt {} ({})  drift {:+.4f} %  {:.2f} M particle-steps/s", now.step,
                                done, shown_time(now.dt), now.reason, 100.0 * now.drift, 1e-6 * rate);
  std::fputs(line.c_str(), stderr);
  std::fflush(stderr);
  drawn_ = true;
}

void Progress::clear() {
  if (drawn_) std::fputs("\r\033[K", stderr);
  drawn_ = false;
}

std::string shown_time(double seconds) {
  struct Scale {
    double unit;
    const char* symbol;
  };
  constexpr std::array<Scale, 4> scales{{{1.0, "s"}, {1e-3, "ms"}, {1e-6, "µs"}, {1e-9, "ns"}}};
  for (const auto& scale : scales)
    if (std::abs(seconds) >= 0.9995 * scale.unit) return fmt::format("{:.3g} {}", seconds / scale.unit, scale.symbol);
  return seconds == 0.0 ? "0 s" : fmt::format("{:.3g} ns", seconds * 1e9);
}

std::string shown_clock(double seconds) {
  constexpr double year = 365.25 * 24.0 * 3600.0;
  if (seconds >= year) return fmt::format("{:.3g} years", seconds / year);
  const auto whole = static_cast<long>(std::ceil(seconds));
  return fmt::format("{}:{:02}:{:02}", whole / 3600, whole / 60 % 60, whole % 60);
}

}  // namespace tektite
