#pragma once

#include <cstddef>
#include <optional>
#include <string_view>

namespace tektite {

/// What toml++ 3.3 must not see.
struct Unreadable {
  std::size_t at;
  const char* what;
  const char* allowed;
};

/// The first of such things, if there is any:
///
/// - A character outside of ASCII, of which kind it would find out by undefined behaviour: one in no string and no
///   comment, where TOML allows none, and one in a string of several lines with nothing but white space between it and
///   a backslash. A mark of byte order at the beginning is allowed.
/// - A key of more than 32 parts: tables are looked through and taken away by calls within calls, for which tens of
///   thousands leave no room. Tables in braces it counts itself, up to 256.
std::optional<Unreadable> first_unreadable(std::string_view text);

}  // namespace tektite
