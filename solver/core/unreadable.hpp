#pragma once

#include <cstddef>
#include <string_view>

namespace tektite {

/// Where the first character outside of ASCII stands that toml++ 3.3 must not see, npos where there is none: of which
/// kind it is, it would find out by undefined behaviour. That is one in no string and no comment, where TOML allows
/// none, and one in a string of several lines with nothing but white space between it and a backslash. A mark of byte
/// order at the beginning is allowed.
std::size_t first_unreadable(std::string_view text);

}  // namespace tektite
