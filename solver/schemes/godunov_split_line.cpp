#include "schemes/godunov_split.hpp"
#include "schemes/godunov_split_scheme.hpp"

namespace tektite {

std::unique_ptr<Scheme> make_godunov_split_line(const SchemeSetup& setup) {
  return make_with_kernel<GodunovSplitScheme, Space::line>(setup);
}

}  // namespace tektite
