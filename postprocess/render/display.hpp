#pragma once
// A private X server. Debian's VTK draws off screen only through one, and a chart of a study must not depend on the
// user's.

#include <sys/types.h>

namespace tektite {

class PrivateDisplay {
 public:
  /// Starts Xvfb on a free display and points DISPLAY at it. Throws RunError, saying what to install, where it cannot.
  PrivateDisplay();
  ~PrivateDisplay();
  PrivateDisplay(const PrivateDisplay&) = delete;
  PrivateDisplay& operator=(const PrivateDisplay&) = delete;

 private:
  pid_t server_;
};

}  // namespace tektite
