#include "schemes/msph_scheme.hpp"

namespace tektite {

template std::unique_ptr<Scheme> make_msph_in<Space::cylindrical>(const SchemeSetup&);

}  // namespace tektite
