#pragma once
// What one rank finds wrong, all have to know, or the others would wait for it for ever.

#include <optional>
#include <string>

#include "core/error.hpp"
#include "parallel/ranks.hpp"

namespace tektite {

/// Of what the ranks have to say, which is mostly nothing, all one after the other.
inline std::string text_of_all(const std::string& own) {
  std::string text;
  for (const auto& words : gather_on_all({own.begin(), own.end()})) text.append(words.begin(), words.end());
  return text;
}

/// work() of every rank, which does not speak with the others. Throws InputError on all where one has thrown it: that
/// of the first of these.
template <class Work>
auto agreed(const Work& work) {
  std::optional<decltype(work())> done;
  std::string fault;
  try {
    done.emplace(work());
  } catch (const InputError& found) {
    fault = found.what();
  }
  for (const auto& words : gather_on_all({fault.begin(), fault.end()}))
    if (!words.empty()) throw InputError(std::string(words.begin(), words.end()));
  return std::move(*done);
}

}  // namespace tektite
