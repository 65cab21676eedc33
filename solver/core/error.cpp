#include "core/error.hpp"

#include <fmt/format.h>

#include <utility>

namespace tektite {
namespace {

/// Control characters, which would cut a message short, break its line or change the terminal, as TOML escapes them.
std::string escaped(const std::string& text) {
  std::string plain;
  for (const char c : text)
    if (const auto code = static_cast<unsigned char>(c); code < 0x20 || code == 0x7F)
      plain += fmt::format("\\u{:04x}", code);
    else
      plain += c;
  return plain;
}

std::string message(const InputFault& fault) {
  std::string text;
  if (!fault.place.file.empty()) {
    text += fault.place.file;
    if (fault.place.line > 0) text += fmt::format(":{}", fault.place.line);
    text += ": ";
  }
  if (!fault.key.empty()) {
    text += fault.key;
    if (!fault.value.empty()) text += " = " + fault.value;
    text += ": ";
  }
  text += fault.reason;
  if (!fault.allowed.empty()) text += " (allowed: " + fault.allowed + ")";
  return escaped(text);
}

}  // namespace

InputError::InputError(InputFault fault) : std::runtime_error(message(fault)), fault_(std::move(fault)) {}

}  // namespace tektite
