#include "core/seal.hpp"

#include <algorithm>
#include <array>
#include <cstdint>
#include <cstring>
#include <fstream>
#include <vector>

#include "core/crc32.hpp"
#include "core/error.hpp"

namespace tektite {
namespace {

struct Seal {
  std::array<char, 12> mark{'t', 'e', 'k', 't', 'i', 't', 'e', ' ', 's', 'e', 'a', 'l'};
  std::uint32_t checksum = 0;
};
static_assert(sizeof(Seal) == 16);

/// Checksum of the first `length` bytes.
std::uint32_t checksum_of(std::ifstream& file, std::uint64_t length) {
  Crc32 checksum;
  std::vector<char> part(1 << 20);
  while (length > 0 && file) {
    file.read(part.data(), static_cast<std::streamsize>(std::min<std::uint64_t>(length, part.size())));
    checksum.take({part.data(), static_cast<std::size_t>(file.gcount())});
    length -= static_cast<std::uint64_t>(file.gcount());
  }
  return checksum.value();
}

}  // namespace

void seal(const std::string& path, std::uint32_t checksum) {
  Seal seal;
  seal.checksum = checksum;
  std::ofstream end(path, std::ios::binary | std::ios::app);
  end.write(reinterpret_cast<const char*>(&seal), sizeof seal);
  end.close();
  if (!end) throw RunError(path + ": cannot be written to its end (is the disk full?)");
}

std::uint32_t checksum_of(const std::string& path, std::uint64_t first, std::uint64_t length) {
  std::ifstream file(path, std::ios::binary);
  file.seekg(static_cast<std::streamoff>(first));
  const auto checksum = checksum_of(file, length);
  if (!file) throw RunError(path + ": what was written to it cannot be read again");
  return checksum;
}

void seal(const std::string& path) {
  std::ifstream file(path, std::ios::binary | std::ios::ate);
  const auto length = file.tellg();
  if (!file) throw RunError(path + ": cannot be written to its end (is it there?)");
  seal(path, checksum_of(path, 0, static_cast<std::uint64_t>(length)));
}

bool check_seal(const std::string& path) {
  std::ifstream file(path, std::ios::binary | std::ios::ate);
  const auto length = static_cast<std::int64_t>(file.tellg()) - static_cast<std::int64_t>(sizeof(Seal));
  if (!file || length <= 0) return false;
  Seal found;
  file.seekg(length);
  file.read(reinterpret_cast<char*>(&found), sizeof found);
  if (!file || found.mark != Seal{}.mark) return false;
  file.seekg(0);
  if (checksum_of(file, static_cast<std::uint64_t>(length)) != found.checksum)
    throw InputError(
        {{path, 0}, {}, {}, "the file is damaged: its checksum is wrong", "a particle file of tektite, whole"});
  return true;
}

}  // namespace tektite
