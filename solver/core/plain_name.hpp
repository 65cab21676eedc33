#pragma once
// Names that a scene gives and that become names of files or of columns.

#include <cstddef>
#include <string_view>

namespace tektite {

inline constexpr const char* plain_characters = "letters, digits, _ and -, at most 100";

/// Letters, digits, _ and - alone, and at least one. A file is called after two such names and its ending, and no file
/// system takes more than 255 letters.
constexpr bool is_plain_name(std::string_view name) {
  constexpr std::size_t longest = 100;
  return !name.empty() && name.size() <= longest &&
         name.find_first_not_of("abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ0123456789_-") ==
             std::string_view::npos;
}

}  // namespace tektite
