#pragma once
// Pieces of a page that carries everything within itself.

#include <string>
#include <string_view>

namespace tektite {

/// Text as it may stand anywhere in a page, in attributes too: & < > " ' as entities, control characters as spaces.
std::string escaped(std::string_view text);

/// The bytes in base 64 (RFC 4648, section 4).
std::string base64(std::string_view bytes);

/// A file as the value of `src`: "data:TYPE;base64,...". Throws RunError where it cannot be read.
std::string data_uri(const std::string& path, const std::string& type);

}  // namespace tektite
