#pragma once
// A handful of particles with a different number in every place, for tests of what stores and moves them.

#include <cstdint>
#include <vector>

#include "core/particles.hpp"

namespace tektite::test {

/// Three and four particles.
inline std::vector<Body> two_bodies() {
  return {{"left", "steel", 1e-3, {0, 3}}, {"right", "aluminium", 2e-3, {3, 7}}};
}

/// Every field that is kept is allocated and filled with positive numbers, no two of a field the same.
inline Particles filled_particles(Space space) {
  Particles particles(space, two_bodies());
  for (const auto& row : field_table) {
    if (!saved(row.keep)) continue;
    particles.allocate(row.field);
    if (row.rank == Rank::integer) {
      std::int64_t next = 1000;
      for (auto& value : particles.integers(row.field)) value = next++;
    } else {
      double next = 1.0 / 3.0 + static_cast<double>(row.field);
      for (auto& value : particles.reals(row.field)) value = next *= 1.0625;
    }
  }
  return particles;
}

}  // namespace tektite::test
