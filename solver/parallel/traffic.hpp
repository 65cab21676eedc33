#pragma once
// What this process has to do with the other ranks of a run.

#include <cstddef>

namespace tektite {

struct Traffic {
  double seconds = 0.0;      ///< in which it sent, received and waited for others
  std::size_t messages = 0;  ///< that it has sent to one rank each; of a reduction one
  std::size_t bytes = 0;     ///< in these
};

/// Since the program began.
const Traffic& traffic();

}  // namespace tektite
