#include "core/apart.hpp"

#include <fmt/format.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cerrno>
#include <csignal>
#include <cstdint>
#include <exception>
#include <filesystem>
#include <fstream>
#include <new>

#include "core/error.hpp"
#include "core/system_words.hpp"
#include "core/wait_for.hpp"

namespace tektite {
namespace {

/// Bytes of address space that this process has.
rlim_t address_space() {
  rlim_t pages = 0;
  std::ifstream("/proc/self/statm") >> pages;
  return pages * static_cast<rlim_t>(::sysconf(_SC_PAGESIZE));
}

void set_bounds(std::uintmax_t file_size) {
  constexpr std::uintmax_t slowest_disk = 10'000'000;  // bytes a second
  constexpr unsigned start = 20;                       // seconds
  ::alarm(start + static_cast<unsigned>(file_size / slowest_disk));
  constexpr rlim_t most_packed = 100;  // bytes in memory for one in the file
  constexpr rlim_t least = rlim_t{1} << 30;
  const rlim_t bytes = address_space() + least + most_packed * file_size;
  const rlimit memory{bytes, bytes}, no_core{0, 0};
  ::setrlimit(RLIMIT_AS, &memory);
  ::setrlimit(RLIMIT_CORE, &no_core);
}

}  // namespace

bool can_be_read(const std::string& path, const std::function<void()>& read) {
  const pid_t child = ::fork();
  if (child < 0)
    throw RunError(fmt::format("{}: no process can be started to read it: {}", path, words_for_error(errno)));
  if (child == 0) {
    for (const int signal : {SIGINT, SIGTERM, SIGALRM}) ::signal(signal, SIG_DFL);
    set_bounds(std::filesystem::file_size(path));
    int code = 0;
    try {
      read();
    } catch (const std::bad_alloc&) {
      code = 1;
    } catch (const std::exception&) {
      code = 0;
    }
    ::_exit(code);
  }
  const int status = wait_for(child, path);
  return WIFEXITED(status) && WEXITSTATUS(status) == 0;
}

}  // namespace tektite
