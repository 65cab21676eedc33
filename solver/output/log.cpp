#include "output/log.hpp"

#include <spdlog/sinks/basic_file_sink.h>
#include <spdlog/sinks/stdout_sinks.h>

#include "core/error.hpp"

namespace tektite {

std::shared_ptr<spdlog::logger> open_log(const std::string& path, bool append) {
  try {
    auto file = std::make_shared<spdlog::sinks::basic_file_sink_mt>(path, !append);
    file->set_pattern("%Y-%m-%d %H:%M:%S.%e  %v");
    auto console = std::make_shared<spdlog::sinks::stdout_sink_mt>();
    console->set_pattern("%v");
    auto log = std::make_shared<spdlog::logger>("run", spdlog::sinks_init_list{console, file});
    log->flush_on(spdlog::level::info);
    log->set_error_handler(
        [path](const std::string&) { throw RunError(path + ": cannot be written (is the disk full?)"); });
    return log;
  } catch (const spdlog::spdlog_ex& fault) {
    throw RunError(path + ": the log cannot be opened: " + fault.what());
  }
}

}  // namespace tektite
