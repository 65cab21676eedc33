#include "core/crc32.hpp"

#include <catch2/catch.hpp>

#include <string>

namespace {

std::uint32_t checksum_of(const std::string& bytes) {
  tektite::Crc32 checksum;
  checksum.take(bytes);
  return checksum.value();
}

TEST_CASE("Checksum: it is CRC-32, by which files of any version are sealed") {
  CHECK(checksum_of("") == 0);
  CHECK(checksum_of("123456789") == 0xcbf43926);
  CHECK(checksum_of("The quick brown fox jumps over the lazy dog") == 0x414fa339);
  CHECK(checksum_of(std::string(32, '\xff')) == 0xff6cab0b);
}

TEST_CASE("Checksum: it does not depend on the parts that the bytes come in") {
  std::string bytes;
  for (int n = 0; n < 50; ++n) bytes.push_back(static_cast<char>(37 * n));
  for (std::size_t cut = 0; cut <= bytes.size(); ++cut) {
    tektite::Crc32 checksum;
    checksum.take({bytes.data(), cut});
    checksum.take({bytes.data() + cut, bytes.size() - cut});
    CHECK(checksum.value() == checksum_of(bytes));
  }
}

TEST_CASE("Checksum: parts that were looked at apart are joined") {
  const std::string bytes = "The quick brown fox jumps over the lazy dog";
  for (std::size_t cut = 0; cut <= bytes.size(); ++cut) {
    tektite::Crc32 checksum;
    for (const auto& part : {bytes.substr(0, cut), bytes.substr(cut)}) checksum.take(checksum_of(part), part.size());
    CHECK(checksum.value() == checksum_of(bytes));
  }
}

}  // namespace
