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

/// work() of every rank, which does not speak with the others. Throws InputError or RunError on all where one has
/// thrown it: that of the first of these.
template <class Work>
auto agreed(const Work& work) {
  if (ranks() == 1) return work();
  constexpr char of_input = 'i', of_run = 'r';
  std::optional<decltype(work())> done;
  std::string fault;
  try {
    done.emplace(work());
  } catch (const InputError& found) {
    fault = of_input + std::string(found.what());
  } catch (const RunError& found) {
    fault = of_run + std::string(found.what());
  }
  for (const auto& words : gather_on_all({fault.begin(), fault.end()})) {
    if (words.empty()) continue;
    const std::string told(words.begin() + 1, words.end());
    if (words.front() == of_run) throw RunError(told);
    throw InputError(told);
  }
  return std::move(*done);
}

}  // namespace tektite
