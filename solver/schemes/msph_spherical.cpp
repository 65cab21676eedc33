#include "schemes/msph_scheme.hpp"

namespace tektite {

template std::unique_ptr<Scheme> make_msph_in<Space::spherical>(const SchemeSetup&);

}  // namespace tektite
