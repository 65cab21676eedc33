#pragma once

#include <memory>

#include "schemes/scheme.hpp"

namespace tektite {

/// Godunov SPH of Parshikov and Medin (2002): the time-split Godunov paper, eq. 15 and 16. Throws InputError where the
/// space is not supported.
std::unique_ptr<Scheme> make_godunov_pm(const SchemeSetup& setup);

// Each space in a translation unit of its own.
std::unique_ptr<Scheme> make_godunov_pm_line(const SchemeSetup& setup);
std::unique_ptr<Scheme> make_godunov_pm_plane_strain(const SchemeSetup& setup);
std::unique_ptr<Scheme> make_godunov_pm_solid(const SchemeSetup& setup);

}  // namespace tektite
