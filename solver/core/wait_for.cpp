#include "core/wait_for.hpp"

#include <fmt/format.h>
#include <sys/wait.h>

#include <cerrno>

#include "core/error.hpp"
#include "core/system_words.hpp"

namespace tektite {

int wait_for(pid_t child, const std::string& who) {
  int status = 0;
  while (::waitpid(child, &status, 0) < 0)
    if (errno != EINTR)
      throw RunError(fmt::format("{}: a process cannot be waited for: {}", who, words_for_error(errno)));
  return status;
}

}  // namespace tektite
