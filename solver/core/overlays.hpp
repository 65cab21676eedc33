#pragma once
// What is laid over a scene: its variant, then each setting in turn.

#include <fmt/format.h>

#include <cstddef>
#include <map>
#include <string>

#include "core/error.hpp"

namespace tektite {

/// Under which the places of the overlay number k are remembered, as they stand in it.
inline std::string overlay_path(std::size_t k) { return fmt::format("overlay.{}", k); }

/// How many there are.
inline std::size_t overlay_count(const std::map<std::string, Place>& places) {
  std::size_t count = 0;
  while (places.contains(overlay_path(count))) ++count;
  return count;
}

/// Which overlay brought what stands at `path`, counted from 1; 0 is the scene. An overlay that has changed something
/// within a table of the scene leaves the table the scene's.
inline std::size_t overlay_of(const std::string& path, const std::map<std::string, Place>& places) {
  const auto here = places.find(path);
  for (auto k = overlay_count(places); k > 0; --k) {
    const auto there = places.find(overlay_path(k - 1) + "." + path);
    if (here != places.end() && there != places.end() && here->second.file == there->second.file &&
        here->second.line == there->second.line)
      return k;
  }
  return 0;
}

}  // namespace tektite
