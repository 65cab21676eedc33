#pragma once

#include <memory>

#include "schemes/scheme.hpp"

namespace tektite {

/// SPH with kernels of the reference configuration: Young et al. (2021), eq. 2, with or without the mixed correction
/// eq. 3-5; neighbours are found once.
std::unique_ptr<Scheme> make_total_lagrangian(const SchemeSetup& setup);

}  // namespace tektite
