#pragma once

#include "core/kernel_type.hpp"
#include "core/particles.hpp"

namespace tektite {

inline bool is_lagrangian(const Particles& particles, std::size_t i) {
  return particles.has(Field::reference_position) &&
         particles.integers(Field::kernel_type)[i] == static_cast<std::int64_t>(KernelType::total_lagrangian);
}

}  // namespace tektite
