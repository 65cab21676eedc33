#pragma once
// The snapshots of a run, DIR/snapshots/NNNNNN.h5, numbered by step, so that an interrupted run does not shift the
// numbers.

#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

namespace tektite {

/// The file of the snapshot that is taken at a step.
std::string snapshot_path(const std::filesystem::path& folder, std::int64_t step);

/// The snapshots in the folder of a run, by step; files with other names are none.
std::vector<std::string> snapshot_files(const std::filesystem::path& folder);

/// Removes what a process that was killed has left of a snapshot it was writing.
void remove_parts_of_snapshots(const std::filesystem::path& folder);

}  // namespace tektite
