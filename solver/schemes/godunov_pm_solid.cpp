#include "schemes/godunov_pm.hpp"
#include "schemes/godunov_pm_scheme.hpp"

namespace tektite {

std::unique_ptr<Scheme> make_godunov_pm_solid(const SchemeSetup& setup) {
  return make_with_kernel<GodunovPmScheme, Space::solid>(setup);
}

}  // namespace tektite
