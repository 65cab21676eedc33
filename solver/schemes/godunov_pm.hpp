#pragma once

#include <memory>

#include "schemes/scheme.hpp"

namespace tektite {

/// Godunov SPH of Parshikov and Medin (2002): the time-split Godunov paper, eq. 15 and 16. Throws InputError where the
/// space is not supported.
std::unique_ptr<Scheme> make_godunov_pm(const SchemeSetup& setup);

}  // namespace tektite
