// The fuzzer of scenes reads them and computes nothing: the table of schemes is there, the schemes are not.
#include <cstdlib>

#include "schemes/eulerian.hpp"
#include "schemes/godunov_pm.hpp"
#include "schemes/godunov_split.hpp"
#include "schemes/msph.hpp"
#include "schemes/total_lagrangian.hpp"

namespace tektite {

std::unique_ptr<Scheme> make_eulerian(const SchemeSetup&) { std::abort(); }
std::unique_ptr<Scheme> make_godunov_pm(const SchemeSetup&) { std::abort(); }
std::unique_ptr<Scheme> make_godunov_split(const SchemeSetup&) { std::abort(); }
std::unique_ptr<Scheme> make_msph(const SchemeSetup&) { std::abort(); }
std::unique_ptr<Scheme> make_ssph(const SchemeSetup&) { std::abort(); }
std::unique_ptr<Scheme> make_total_lagrangian(const SchemeSetup&) { std::abort(); }

}  // namespace tektite
