#pragma once

#include <functional>
#include <string>

namespace tektite {

/// Joins the other processes and runs `body` as run_program() does; gives the exit code. A rank beside the first one is
/// silent: it comes to the same faults, and leaves it to the first one to tell them and to end all; where that does
/// not, this one does.
int run_program_on_ranks(const std::string& name, const std::function<int()>& body);

}  // namespace tektite
