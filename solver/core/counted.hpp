#pragma once
// Numbers of things in words: one of them has no plural.

#include <fmt/format.h>

#include <cstddef>
#include <string>
#include <string_view>

namespace tektite {

/// "1 particle", "12 particles".
inline std::string counted(std::size_t number, std::string_view thing) {
  return fmt::format("{} {}{}", number, thing, number == 1 ? "" : "s");
}

}  // namespace tektite
