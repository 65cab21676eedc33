#include "schemes/godunov_settings.hpp"

namespace tektite {
namespace {

template <class Models>
Models read_or_first(Section& parent, const std::string& key) {
  auto section = parent.section_or_empty(key);
  const auto names = Family<Models>::names();
  section.choice("model", names, names.front());
  return Family<Models>::read(section);
}

}  // namespace

GodunovSettings read_godunov(Section& scheme, Space space) {
  GodunovSettings settings;
  settings.order = static_cast<int>(scheme.integer("order", {1.0, 2.0}, 2));
  const std::vector<std::string> splittings{"lie-trotter", "strang"};
  settings.strang = scheme.choice("splitting", splittings, "lie-trotter") == "strang";
  if (settings.strang && space == Space::plane_stress)
    throw scheme.fault("splitting", "the two halves of strang leave a stress across a thin plate", "lie-trotter");
  settings.riemann = read_or_first<Riemann>(scheme, "riemann");
  settings.limiter = read_or_first<Limiter>(scheme, "limiter");
  return settings;
}

}  // namespace tektite
