#include "preprocess/progress.hpp"

#include <fmt/format.h>
#include <unistd.h>

#include <utility>

#include "parallel/ranks.hpp"

namespace tektite::preprocess {

Progress::Progress(std::string what, std::size_t total)
    : what_(std::move(what)), total_(total), shown_(rank() == 0 && isatty(STDERR_FILENO) != 0) {}

Progress::~Progress() {
  if (shown_) fmt::print(stderr, "\r\033[K");
}

void Progress::advance() {
  const auto done = ++done_;
  const auto percent = [&](std::size_t part) { return 100 * part / total_; };
  if (shown_ && percent(done) != percent(done - 1)) fmt::print(stderr, "\r{}: {} %", what_, percent(done));
}

}  // namespace tektite::preprocess
