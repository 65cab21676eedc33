#include "schemes/godunov_split_scheme.hpp"

namespace tektite {

template std::unique_ptr<Scheme> make_godunov_split_in<Space::plane_stress>(const SchemeSetup&);

}  // namespace tektite
