#pragma once

#include <csignal>
#include <cstring>

namespace tektite {

/// What the system says of a value of errno and of a signal's number; unlike strerror and strsignal on any thread.
inline const char* words_for_error(int reason) {
  const char* words = ::strerrordesc_np(reason);
  return words ? words : "unknown reason";
}
inline const char* words_for_signal(int signal) {
  const char* words = ::sigdescr_np(signal);
  return words ? words : "unknown signal";
}

}  // namespace tektite
