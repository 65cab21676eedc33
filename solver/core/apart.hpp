#pragma once
// Files that cannot be trusted are first read where that can do no harm.

#include <functional>
#include <string>

namespace tektite {

/// Whether `read`, which reads the file, comes to its end in a process of its own: false where it crashes, takes longer
/// than a slow disk, or needs far more memory than the file has bytes. Other exceptions count as its end: they are
/// thrown again, and told, where the file is read in earnest.
bool can_be_read(const std::string& path, const std::function<void()>& read);

}  // namespace tektite
