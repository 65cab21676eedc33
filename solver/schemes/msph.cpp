#include "schemes/msph.hpp"

namespace tektite {

// Each space in a translation unit of its own: msph_line.cpp and so on.
template <Space space>
std::unique_ptr<Scheme> make_msph_in(const SchemeSetup& setup);

namespace {

void refuse(const SchemeSetup& setup, const std::string& key, const std::string& value, const std::string& allowed) {
  throw InputError({{}, key, value, "the scheme " + setup.settings.type + " does not support it", allowed});
}

void check_support(const SchemeSetup& setup) {
  if (setup.settings.contact) refuse(setup, "contact", {}, "no [contact]: bodies act through the sums");
  const bool radial_line = setup.particles.dimensions() == 1 && hoops_of(setup.particles.space()) > 0;
  for (const auto& body : setup.particles.bodies()) {
    const auto& material = setup.materials.at(body.material);
    if (!std::holds_alternative<NoDamage>(material.damage))
      refuse(setup, "material." + material.name + ".damage", {}, "none");
    if (radial_line && !std::holds_alternative<NoStrength>(material.strength))
      refuse(setup, "material." + material.name + ".strength", {}, "none in a cylindrical or spherical space");
  }
}

}  // namespace

std::unique_ptr<Scheme> make_ssph(const SchemeSetup& setup) {
  check_support(setup);
  switch (setup.particles.space()) {
    case Space::line:
      return make_msph_in<Space::line>(setup);
    case Space::plane_strain:
      return make_msph_in<Space::plane_strain>(setup);
    case Space::solid:
      return make_msph_in<Space::solid>(setup);
    case Space::cylindrical:
      return make_msph_in<Space::cylindrical>(setup);
    case Space::spherical:
      return make_msph_in<Space::spherical>(setup);
    case Space::axisymmetric:
      return make_msph_in<Space::axisymmetric>(setup);
    case Space::plane_stress:
      break;
  }
  refuse(setup, "space", "plane-stress", "line, plane-strain, solid, cylindrical, spherical, axisymmetric");
  return nullptr;
}

std::unique_ptr<Scheme> make_msph(const SchemeSetup& setup) {
  if (setup.settings.kernel != TruncatedGaussian::name)
    refuse(setup, "smoothing.kernel", setup.settings.kernel, std::string(TruncatedGaussian::name));
  return make_ssph(setup);
}

}  // namespace tektite
