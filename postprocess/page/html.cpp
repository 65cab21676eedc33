#include "postprocess/page/html.hpp"

#include <cstdint>
#include <fstream>
#include <iterator>

#include "core/error.hpp"

namespace tektite {

std::string escaped(std::string_view text) {
  std::string safe;
  for (const char c : text) switch (c) {
      case '&':
        safe += "&amp;";
        break;
      case '<':
        safe += "&lt;";
        break;
      case '>':
        safe += "&gt;";
        break;
      case '"':
        safe += "&quot;";
        break;
      case '\'':
        safe += "&#39;";
        break;
      default:
        safe += static_cast<unsigned char>(c) < 0x20 && c != '\n' && c != '\t' ? ' ' : c;
    }
  return safe;
}

std::string base64(std::string_view bytes) {
  constexpr std::string_view digits = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
  std::string text;
  for (std::size_t k = 0; k < bytes.size(); k += 3) {
    std::uint32_t three = 0;
    for (std::size_t j = 0; j < 3; ++j)
      three = three << 8 | (k + j < bytes.size() ? static_cast<unsigned char>(bytes[k + j]) : 0U);
    for (std::size_t j = 0; j < 4; ++j) text += k + j > bytes.size() ? '=' : digits[three >> (18 - 6 * j) & 63U];
  }
  return text;
}

std::string data_uri(const std::string& path, const std::string& type) {
  std::ifstream file(path, std::ios::binary);
  if (!file) throw RunError(path + ": cannot be read");
  return "data:" + type + ";base64," + base64(std::string(std::istreambuf_iterator<char>(file), {}));
}

}  // namespace tektite
