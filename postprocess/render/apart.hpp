#pragma once
// VTK draws through an X server and ends the process where there is none or where it is lost: so a child draws.

#include <functional>
#include <string>
#include <vector>

namespace tektite {

/// Tells a line to whoever asked for the drawing.
using Tell = std::function<void(const std::string&)>;

/// Runs `draw` in a child process with a private X server and gives what it told:
/// or, where it threw or ended, the warning why there are no pictures. Whatever happens to it, this process goes on.
std::vector<std::string> draw_apart(const std::function<void(const Tell&)>& draw);

}  // namespace tektite
