#pragma once
// A checksum behind the end of a particle file. HDF5 does not look there, and its own checksums do not cover all that
// its library reads before it notices damage, so a file is checked as a whole before the library sees it.

#include <cstdint>
#include <string>

namespace tektite {

/// Appends the checksum of all bytes to a file. Throws RunError.
void seal(const std::string& path);

/// The same where it is known, of parts that were looked at by several processes (Crc32 joins them). Throws RunError.
void seal(const std::string& path, std::uint32_t checksum);
/// The checksum of some bytes of a file. Throws RunError.
std::uint32_t checksum_of(const std::string& path, std::uint64_t first, std::uint64_t length);

/// Whether a file is sealed. Throws InputError where it is and is not as it was.
bool check_seal(const std::string& path);

}  // namespace tektite
