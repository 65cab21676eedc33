#include "core/unreadable.hpp"

#include <algorithm>

namespace tektite {
namespace {

bool is_outside_ascii(char c) { return static_cast<unsigned char>(c) > 127; }

bool ends_key(char c) { return std::string_view("[]{}=,\n").find(c) != std::string_view::npos; }

/// Behind the string whose first quote stands at `at`, or behind its line where it has no end there; but at a character
/// that must not be seen where it holds one.
std::size_t after_string(std::string_view text, std::size_t at) {
  const char quote = text[at];
  const std::string_view three = quote == '"' ? "\"\"\"" : "'''";
  const bool of_many_lines = text.substr(at, 3) == three;
  at += of_many_lines ? 3 : 1;
  while (at < text.size()) {
    if (quote == '"' && text[at] == '\\') {
      ++at;
      if (of_many_lines) {
        const auto next = std::min(text.find_first_not_of(" \t\r\n", at), text.size());
        if (next < text.size() && is_outside_ascii(text[next])) return next;
      }
      ++at;  // what is escaped
    } else if (of_many_lines && text.substr(at, 3) == three) {
      return std::min(text.find_first_not_of(quote, at), at + 5);  // up to two more belong to the string
    } else if (!of_many_lines && (text[at] == quote || text[at] == '\n')) {
      return at + 1;
    } else {
      ++at;
    }
  }
  return text.size();
}

}  // namespace

std::optional<Unreadable> first_unreadable(std::string_view text) {
  constexpr std::string_view byte_order = "\xEF\xBB\xBF";
  constexpr int most_parts = 32;
  int dots = 0;  // in the key that stands here
  for (std::size_t at = text.starts_with(byte_order) ? byte_order.size() : 0; at < text.size();) {
    if (text[at] == '#')
      at = text.find('\n', at);
    else if (text[at] == '"' || text[at] == '\'')
      at = after_string(text, at);
    else if (is_outside_ascii(text[at]))
      return Unreadable{at, "a character outside of ASCII",
                        "such characters in strings, not behind a backslash, and in comments"};
    else {
      if (text[at] == '.' && ++dots == most_parts)
        return Unreadable{at, "a key of too many parts", "up to 32 parts with dots between them"};
      if (ends_key(text[at])) dots = 0;
      ++at;
    }
  }
  return std::nullopt;
}

}  // namespace tektite
