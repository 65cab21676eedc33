#pragma once

#include <memory>

#include "schemes/scheme.hpp"

namespace tektite {

/// Conventional SPH: kernels in current coordinates, Young et al. (2021), eq. 1 without correction, eq. 6-7, leapfrog.
std::unique_ptr<Scheme> make_eulerian(const SchemeSetup& setup);

}  // namespace tektite
