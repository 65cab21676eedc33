#pragma once

#include "core/snapshot.hpp"

namespace tektite {

/// Every rank reads as many rows of the file as the others, and owns their particles until they are dealt
/// (distribution.hpp); one process has all. Throws InputError, on all ranks the same.
Snapshot read_snapshot_on_ranks(const std::string& path);

/// All ranks write one file together, the same as a single process: each has its own particles and their copies in
/// `snapshot`, and the same scene and state. Throws RunError.
void write_snapshot_on_ranks(const Snapshot& snapshot, const std::string& path);

}  // namespace tektite
