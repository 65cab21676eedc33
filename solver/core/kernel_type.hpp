#pragma once
// In which coordinates a particle's kernel lives: the numbers of the field kernel_type.

#include <cstdint>

namespace tektite {

enum class KernelType : std::int64_t {
  total_lagrangian = 0,  ///< of the places at the start
  eulerian = 1,          ///< of the places now
};

}  // namespace tektite
