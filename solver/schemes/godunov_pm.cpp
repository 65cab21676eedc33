#include "schemes/godunov_pm.hpp"

#include "schemes/cold_gas.hpp"
#include "schemes/make_scheme_in.hpp"

namespace tektite {

// Each space in a translation unit of its own: godunov_pm_line.cpp and so on.
template <Space space>
std::unique_ptr<Scheme> make_godunov_pm_in(const SchemeSetup& setup);

std::unique_ptr<Scheme> make_godunov_pm(const SchemeSetup& setup) {
  refuse_cold_gas(setup);
  return in_space<Space::line, Space::plane_strain, Space::plane_stress, Space::solid>(
      setup, [&](auto space) { return make_godunov_pm_in<space()>(setup); });
}

}  // namespace tektite
