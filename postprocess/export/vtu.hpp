#pragma once
// Files for ParaView.

#include <string>
#include <vector>

#include "core/snapshot.hpp"

namespace tektite {

/// Writes the snapshot as compressed binary VTU (make_grid tells what is in it). Throws RunError.
void write_vtu(const Snapshot& snapshot, const std::string& path);

struct TimedFile {
  double time = 0.0;  ///< in s
  std::string path;   ///< relative to the folder of the collection
};

/// Writes the collection that ParaView opens; times have all their digits. Throws RunError.
void write_pvd(const std::vector<TimedFile>& files, const std::string& path);

}  // namespace tektite
