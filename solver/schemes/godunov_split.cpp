#include "schemes/godunov_split.hpp"

#include "schemes/cold_gas.hpp"
#include "schemes/godunov_settings.hpp"
#include "schemes/make_scheme_in.hpp"

namespace tektite {

// Each space in a translation unit of its own: godunov_split_line.cpp and so on.
template <Space space>
std::unique_ptr<Scheme> make_godunov_split_in(const SchemeSetup& setup);

std::unique_ptr<Scheme> make_godunov_split(const SchemeSetup& setup) {
  if (!std::holds_alternative<ExactRiemann>(setup.settings.godunov->riemann)) refuse_cold_gas(setup);
  return in_space<Space::line, Space::plane_strain, Space::plane_stress, Space::solid>(
      setup, [&](auto space) { return make_godunov_split_in<space()>(setup); });
}

}  // namespace tektite
