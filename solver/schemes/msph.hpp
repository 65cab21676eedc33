#pragma once

#include <memory>

#include "schemes/scheme.hpp"

namespace tektite {

/// Modified SPH, in its strong form or with adjoint forces, with derivatives that are exact for quadratic fields: Batra
/// and Zhang (2008). Throws InputError where it does not support the space, the kernel, contact or strength in a radial
/// line.
std::unique_ptr<Scheme> make_msph(const SchemeSetup& setup);

/// The same with the symmetric matrix that section 7 of that paper announces: any kernel.
std::unique_ptr<Scheme> make_ssph(const SchemeSetup& setup);

}  // namespace tektite
