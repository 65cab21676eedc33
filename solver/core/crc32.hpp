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
  /// The same as to take so many bytes whose checksum is known.
  void take(std::uint32_t checksum, std::uint64_t length) {
    state_ = ::crc32_combine(state_, checksum, static_cast<z_off_t>(length));
  }
  /// Of all bytes so far.
  std::uint32_t value() const { return static_cast<std::uint32_t>(state_); }

 private:
  uLong state_ = ::crc32_z(0, nullptr, 0);
};

}  // namespace tektite
