#pragma once

#include <cstdint>
#include <filesystem>
#include <string>

namespace tektite {

/// DIR/snapshots/NNNNNN.h5, numbered by step, so that an interrupted run does not shift the numbers.
std::string snapshot_path(const std::filesystem::path& folder, std::int64_t step);

/// The snapshot of the latest step; throws InputError where there is none.
std::string newest_snapshot(const std::filesystem::path& folder);

/// Removes the snapshots of an earlier run in this folder.
void remove_snapshots(const std::filesystem::path& folder);

}  // namespace tektite
