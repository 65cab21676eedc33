#include "schemes/msph.hpp"

#include "schemes/make_scheme_in.hpp"

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
  return in_space<Space::line, Space::plane_strain, Space::solid, Space::cylindrical, Space::spherical,
                  Space::axisymmetric>(setup, [&](auto space) { return make_msph_in<space()>(setup); });
}

std::unique_ptr<Scheme> make_msph(const SchemeSetup& setup) {
  if (setup.settings.kernel != TruncatedGaussian::name)
    refuse(setup, "smoothing.kernel", setup.settings.kernel, std::string(TruncatedGaussian::name));
  return make_ssph(setup);
}

}  // namespace tektite
