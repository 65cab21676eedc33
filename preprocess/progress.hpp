#pragma once
// A line of progress on standard error, where that is a terminal; nothing otherwise. Of several ranks the
// first tells its own.

#include <atomic>
#include <cstddef>
#include <string>

namespace tektite::preprocess {

class Progress {
 public:
  Progress(std::string what, std::size_t total);
  ~Progress();  ///< wipes the line
  Progress(const Progress&) = delete;
  Progress& operator=(const Progress&) = delete;

  /// One of `total` is done; may be called from any thread.
  void advance();

 private:
  std::string what_;
  std::size_t total_;
  std::atomic<std::size_t> done_{0};
  bool shown_;
};

}  // namespace tektite::preprocess
