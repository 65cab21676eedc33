#pragma once

#include <sys/types.h>

#include <string>

namespace tektite {

/// The status, as of waitpid(2), by which a child of this program ends; signals that come meanwhile do not end the
/// waiting. Throws RunError, which begins with `who`, where there is no such child.
int wait_for(pid_t child, const std::string& who);

}  // namespace tektite
