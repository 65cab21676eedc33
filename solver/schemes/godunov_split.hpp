#pragma once

#include <memory>

#include "schemes/scheme.hpp"

namespace tektite {

/// Time-split Godunov SPH of first or second order (Connolly, Iannucci, Hillier and Pope 2013, section 3.3). Throws
/// InputError where the space is not supported.
std::unique_ptr<Scheme> make_godunov_split(const SchemeSetup& setup);

}  // namespace tektite
