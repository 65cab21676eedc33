#pragma once
// Reductions whose order does not depend on the number of threads: parts whose size follows from the count alone, then
// the parts one by one.
// Sums over particles are those of sums.hpp, which do not depend on the ranks either.

#include <algorithm>
#include <cstddef>
#include <vector>

#include "parallel/ranks.hpp"
#include "parallel/unfused.hpp"

namespace tektite {

/// Folds `body(value, i)` over 0 ≤ i < count. `Value` starts as `start` in every part and is joined by
/// `join(whole, part)`.
template <class Value, class Body, class Join>
TEKTITE_UNFUSED Value reduce(std::size_t count, const Value& start, const Body& body, const Join& join) {
  constexpr std::size_t longest = 4096, least_parts = 64;  // so many, that threads have about as much to do
  const std::size_t part_size = std::clamp<std::size_t>(count / least_parts, 1, longest);
  const std::size_t parts = (count + part_size - 1) / part_size;
  struct Part {  // not the bare value: a std::vector<bool> packs those of several threads into one word
    Value value;
  };
  std::vector<Part> values(parts, Part{start});
#pragma omp parallel for schedule(static)
  for (std::size_t part = 0; part < parts; ++part) {
    Value value = start;
    const std::size_t end = std::min(count, (part + 1) * part_size);
    for (std::size_t i = part * part_size; i < end; ++i) body(value, i);
    values[part].value = value;
  }
  Value whole = start;
  for (const auto& part : values) join(whole, part.value);
  return whole;
}

/// Over the particles of all ranks, those that several have taken several times: for what does not depend on that, nor
/// on any order, such as the least value.
template <class Value, class Body, class Join>
Value reduce(const Particles& particles, const Value& start, const Body& body, const Join& join) {
  return over_ranks(particles, reduce(particles.count(), start, body, join), join);
}

/// The same over those of a range, such as a body's.
template <class Value, class Body, class Join>
Value reduce(const Particles& particles, const Range& range, const Value& start, const Body& body, const Join& join) {
  const auto shifted = [&](Value& value, std::size_t n) { body(value, range.begin + n); };
  return over_ranks(particles, reduce(range.size(), start, shifted, join), join);
}

/// Whether tell(i) for any particle of a range, on any rank.
template <class Tell>
bool any_over(const Particles& particles, const Range& range, const Tell& tell) {
  return reduce(
      particles, range, false, [&](bool& any, std::size_t i) { any = any || tell(i); }, either);
}

/// For how many particles of a range tell(i), on all ranks, each counted once.
template <class Tell>
std::size_t count_over(const Particles& particles, const Range& range, const Tell& tell) {
  return reduce(
      particles, range, std::size_t{0},
      [&, counts = Owned(particles)](std::size_t& count, std::size_t i) { count += counts(i) && tell(i) ? 1 : 0; },
      [](std::size_t& whole, std::size_t part) { whole += part; });
}

/// How many particles a body has on all ranks.
inline std::size_t size_of(const Particles& particles, const Body& body) {
  if (!distributed(particles)) return body.range.size();
  return count_over(particles, body.range, [](std::size_t) { return true; });
}

}  // namespace tektite
