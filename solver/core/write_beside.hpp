#pragma once
// Nothing computed is lost: a file is written beside its place, brought to the disk, and renamed into it.

#include <functional>
#include <string>

namespace tektite {

/// What a file that is being written beside its place has behind its name; a process that was killed leaves one.
inline constexpr const char* part_ending = ".part";

/// Calls `write` with the path of a temporary file in the same folder, then syncs and renames it to `path`. Where
/// anything fails the temporary file is removed and `path` is as it was. Creates missing folders. Throws RunError.
void write_beside(const std::string& path, const std::function<void(const std::string&)>& write);

/// The same for a text.
void write_text_beside(const std::string& path, const std::string& text);

/// Brings what was written to a file, or the entries of a folder, to the disk. Throws RunError.
void bring_to_disk(const std::string& path);

}  // namespace tektite
