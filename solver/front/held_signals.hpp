#pragma once

#include <chrono>
#include <csignal>
#include <initializer_list>

namespace tektite::front {

/// While it lives, these signals wait until they are asked for.
class HeldSignals {
 public:
  explicit HeldSignals(std::initializer_list<int> signals) {
    sigemptyset(&held_);
    for (const int signal : signals) sigaddset(&held_, signal);
    ::pthread_sigmask(SIG_BLOCK, &held_, &before_);
  }
  ~HeldSignals() { ::pthread_sigmask(SIG_SETMASK, &before_, nullptr); }
  HeldSignals(const HeldSignals&) = delete;
  HeldSignals& operator=(const HeldSignals&) = delete;

  int wait() const { return ::sigwaitinfo(&held_, nullptr); }
  /// Whether one of them comes within this time.
  bool come_within(std::chrono::seconds time) const {
    const timespec longest{time.count(), 0};
    return ::sigtimedwait(&held_, nullptr, &longest) > 0;
  }
  const sigset_t& held() const { return held_; }
  const sigset_t& before() const { return before_; }

 private:
  sigset_t held_, before_;
};

}  // namespace tektite::front
