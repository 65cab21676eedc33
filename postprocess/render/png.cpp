#include "postprocess/render/png.hpp"

#include <zlib.h>

#include <cstdint>
#include <new>
#include <string_view>

#include "core/write_beside.hpp"

namespace tektite {
namespace {

std::string big_endian(std::uint32_t number) {
  std::string bytes;
  for (const int shift : {24, 16, 8, 0}) bytes.push_back(static_cast<char>(number >> shift & 0xff));
  return bytes;
}

/// Length, type, content and checksum. Source: ISO/IEC 15948 (PNG), 5.3.
std::string chunk(std::string_view type, const std::string& content) {
  const auto sealed = std::string(type) + content;
  const auto checksum = crc32_z(0, reinterpret_cast<const Bytef*>(sealed.data()), sealed.size());
  return big_endian(static_cast<std::uint32_t>(content.size())) + sealed +
         big_endian(static_cast<std::uint32_t>(checksum));
}

/// The rows from the highest down, each behind the number of its filter: none, since paper and flat colours shrink as
/// well as they are, and to choose among filters takes as long as all the rest.
std::string shrunk_rows(const Canvas& canvas) {
  constexpr char no_filter = 0;
  std::string rows;
  rows.reserve(static_cast<std::size_t>(canvas.height()) * (3 * static_cast<std::size_t>(canvas.width()) + 1));
  for (int y = canvas.height() - 1; y >= 0; --y) {
    rows.push_back(no_filter);
    rows.append(reinterpret_cast<const char*>(canvas.row(y)), 3 * static_cast<std::size_t>(canvas.width()));
  }
  auto size = compressBound(rows.size());
  std::string shrunk(size, '\0');
  if (compress(reinterpret_cast<Bytef*>(shrunk.data()), &size, reinterpret_cast<const Bytef*>(rows.data()),
               rows.size()) != Z_OK)
    throw std::bad_alloc();  // the only way in which it fails
  shrunk.resize(size);
  return shrunk;
}

}  // namespace

void write_png(const Canvas& canvas, const std::string& path) {
  const std::string eight_bits_of_red_green_blue("\x08\x02\0\0\0", 5);
  write_text_beside(path, "\x89PNG\r\n\x1a\n" +
                              chunk("IHDR", big_endian(static_cast<std::uint32_t>(canvas.width())) +
                                                big_endian(static_cast<std::uint32_t>(canvas.height())) +
                                                eight_bits_of_red_green_blue) +
                              chunk("IDAT", shrunk_rows(canvas)) + chunk("IEND", ""));
}

}  // namespace tektite
