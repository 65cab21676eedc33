#pragma once
// Slope limiters. The paper multiplies the slope ΔQ_i by φ(ΔQ_j/ΔQ_i) and ΔQ_j by φ(ΔQ_i/ΔQ_j); every limiter here has
// φ(r)/r = φ(1/r) (what the paper prints after eq. 27 as φ(r) = 1/φ(r)), so both are one and the same slope, a
// symmetric function of the two. That is what a limiter gives: limiter(a, b) = φ(b/a) a, so φ(r) = limiter(1, r).

#include <variant>

#include "physics/limiters/monotonized_central.hpp"
#include "physics/limiters/sweby.hpp"
#include "physics/limiters/van_leer.hpp"

namespace tektite {

/// The first is what a scene gets that names none: of those that are sharp on shocks it feeds waves that ring the least
/// (docs/stability.md, `energy-debt`).
using Limiter = std::variant<VanLeerLimiter, MonotonizedCentralLimiter, SwebyLimiter>;

}  // namespace tektite
