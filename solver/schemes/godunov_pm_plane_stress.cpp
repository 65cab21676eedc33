#include "schemes/godunov_pm_scheme.hpp"

namespace tektite {

template std::unique_ptr<Scheme> make_godunov_pm_in<Space::plane_stress>(const SchemeSetup&);

}  // namespace tektite
