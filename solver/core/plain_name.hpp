#pragma once
// Names that a scene gives and that become names of files or of columns.

#include <string_view>

namespace tektite {

inline constexpr const char* plain_characters = "letters, digits, _ and -";

/// Letters, digits, _ and - alone, and at least one.
constexpr bool is_plain_name(std::string_view name) {
  return !name.empty() && name.find_first_not_of("abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ0123456789_-") ==
                              std::string_view::npos;
}

}  // namespace tektite
