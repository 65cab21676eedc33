#pragma once

#include <spdlog/spdlog.h>
#include <memory>
#include <string>

namespace tektite {

/// A log that goes to standard output, its first sink, and, with time stamps, to a file; `append` where a run is
/// resumed. Throws RunError.
std::shared_ptr<spdlog::logger> open_log(const std::string& path, bool append);

}  // namespace tektite
