#pragma once
// A checksum behind the end of a particle file. HDF5 does not look there, and its own checksums do not cover all that
// its library reads before it notices damage, so a file is checked as a whole before the library sees it.

#include <string>

namespace tektite {

/// Appends the checksum of all bytes to a file. Throws RunError.
void seal(const std::string& path);

/// Whether a file is sealed. Throws InputError where it is and is not as it was.
bool check_seal(const std::string& path);

}  // namespace tektite
