#pragma once

#include <zlib.h>

#include <cstdint>
#include <span>

namespace tektite {

/// The checksum CRC-32 of ISO 3309, by zlib: every particle file that is read or written goes through it.
class Crc32 {
 public:
  void take(std::span<const char> bytes) {
    state_ = ::crc32_z(state_, reinterpret_cast<const Bytef*>(bytes.data()), bytes.size());
  }
  /// Of all bytes so far.
  std::uint32_t value() const { return static_cast<std::uint32_t>(state_); }

 private:
  uLong state_ = ::crc32_z(0, nullptr, 0);
};

}  // namespace tektite
