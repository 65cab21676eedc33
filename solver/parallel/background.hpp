#pragma once
// One piece of work beside the computation, on a thread of its own.

#include <chrono>
#include <csignal>
#include <functional>
#include <future>

namespace tektite {

class Background {
 public:
  Background() = default;
  Background(const Background&) = delete;
  Background& operator=(const Background&) = delete;
  /// Waits until it is done.
  ~Background() {
    if (busy()) work_.wait();
  }

  /// Begins; what was begun before has been finished. Where the system has no thread to give, finish() does the work.
  void start(const std::function<void()>& work) {
    // The signals that end a run go to the thread that computes: they would cut this one's writing short.
    sigset_t ending, before;
    sigemptyset(&ending);
    sigaddset(&ending, SIGINT);
    sigaddset(&ending, SIGTERM);
    pthread_sigmask(SIG_BLOCK, &ending, &before);
    work_ = std::async(std::launch::async | std::launch::deferred, work);
    pthread_sigmask(SIG_SETMASK, &before, nullptr);
  }

  /// Whether something was begun, and not finished yet.
  bool busy() const { return work_.valid(); }
  /// Whether finish() would have to wait.
  bool at_work() const { return busy() && work_.wait_for(std::chrono::seconds(0)) == std::future_status::timeout; }
  /// Waits until it is done; throws what it threw.
  void finish() {
    if (busy()) work_.get();
  }

 private:
  std::future<void> work_;
};

}  // namespace tektite
