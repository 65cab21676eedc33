#pragma once

#include <cstdint>
#include <string>

#include "core/crc32.hpp"
#include "core/seal.hpp"
#include "parallel/agreed.hpp"

namespace tektite {

/// The checksum of a file of this length that all ranks have written, of which each reads a part. Throws RunError, on
/// all ranks the same.
inline std::uint32_t checksum_by_all(const std::string& path, std::uint64_t length) {
  const auto parts = static_cast<std::uint64_t>(ranks());
  const auto begin = [&](int part) { return length / parts * part + length % parts * part / parts; };
  const auto size = begin(rank() + 1) - begin(rank());
  const auto own = agreed([&] { return checksum_of(path, begin(rank()), size); });
  Crc32 whole;
  for (const auto& words : gather_on_all({own, size})) whole.take(static_cast<std::uint32_t>(words[0]), words[1]);
  return whole.value();
}

}  // namespace tektite
