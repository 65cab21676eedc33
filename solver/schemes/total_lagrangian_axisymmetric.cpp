#include "schemes/total_lagrangian_scheme.hpp"

namespace tektite {

template std::unique_ptr<Scheme> make_total_lagrangian_in<Space::axisymmetric>(const SchemeSetup&);

}  // namespace tektite
