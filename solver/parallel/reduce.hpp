#pragma once
// Reductions whose order does not depend on the number of threads: parts of fixed size, then the parts one by one.
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
  constexpr std::size_t part_size = 4096;
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

}  // namespace tektite
