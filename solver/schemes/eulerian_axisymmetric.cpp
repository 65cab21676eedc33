#include "schemes/eulerian_scheme.hpp"

namespace tektite {

template std::unique_ptr<Scheme> make_eulerian_in<Space::axisymmetric>(const SchemeSetup&);

}  // namespace tektite
