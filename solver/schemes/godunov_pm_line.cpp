#include "schemes/godunov_pm.hpp"
#include "schemes/godunov_pm_scheme.hpp"

namespace tektite {

std::unique_ptr<Scheme> make_godunov_pm_line(const SchemeSetup& setup) {
  return make_with_kernel<GodunovPmScheme, Space::line>(setup);
}

}  // namespace tektite
