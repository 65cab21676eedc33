#pragma once
// Where the time of a run goes, by the names of its passes.

#include <chrono>
#include <string>
#include <utility>
#include <vector>

namespace tektite {

class Profile {
 public:
  using Clock = std::chrono::steady_clock;

  /// Counts the time until it is destroyed under a name.
  class Scope {
   public:
    Scope(Profile& profile, const char* name) : profile_(profile), name_(name), start_(Clock::now()) {}
    ~Scope() { profile_.add(name_, std::chrono::duration<double>(Clock::now() - start_).count()); }
    Scope(const Scope&) = delete;
    Scope& operator=(const Scope&) = delete;

   private:
    Profile& profile_;
    const char* name_;
    Clock::time_point start_;
  };

  Scope time(const char* name) { return Scope(*this, name); }

  void add(const char* name, double seconds) {
    for (auto& [known, sum] : seconds_)
      if (known == name) {
        sum += seconds;
        return;
      }
    seconds_.emplace_back(name, seconds);
  }

  /// Names with seconds, in the order in which they first came.
  const std::vector<std::pair<std::string, double>>& seconds() const { return seconds_; }

 private:
  std::vector<std::pair<std::string, double>> seconds_;
};

}  // namespace tektite
