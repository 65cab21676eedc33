#pragma once
// The checksum CRC-32 of ISO 3309, eight bytes at a time by a table for each of them (Kounavis and Berry 2008): every
// particle file that is read or written goes through it.

#include <array>
#include <bit>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <span>

namespace tektite {

class Crc32 {
 public:
  void take(std::span<const char> bytes) {
    static_assert(std::endian::native == std::endian::little, "eight bytes are read as one number");
    std::size_t n = 0;
    for (; n + width <= bytes.size(); n += width) {
      std::uint64_t eight;
      std::memcpy(&eight, bytes.data() + n, width);
      eight ^= state_;
      state_ = 0;
      for (std::size_t k = 0; k < width; ++k) state_ ^= tables[width - 1 - k][eight >> 8 * k & 0xff];
    }
    for (; n < bytes.size(); ++n)
      state_ = state_ >> 8 ^ tables[0][(state_ ^ static_cast<unsigned char>(bytes[n])) & 0xff];
  }
  /// Of all bytes so far.
  std::uint32_t value() const { return ~state_; }

 private:
  static constexpr std::size_t width = 8;
  /// tables[k][b]: what a byte b does to the checksum when k bytes follow it.
  static constexpr auto tables = [] {
    constexpr std::uint32_t polynomial = 0xedb88320;
    std::array<std::array<std::uint32_t, 256>, width> made{};
    for (std::uint32_t b = 0; b < 256; ++b) {
      std::uint32_t rest = b;
      for (int bit = 0; bit < 8; ++bit) rest = rest >> 1 ^ (rest & 1 ? polynomial : 0);
      made[0][b] = rest;
    }
    for (std::size_t k = 1; k < width; ++k)
      for (std::size_t b = 0; b < 256; ++b) made[k][b] = made[k - 1][b] >> 8 ^ made[0][made[k - 1][b] & 0xff];
    return made;
  }();

  std::uint32_t state_ = 0xffffffff;
};

}  // namespace tektite
