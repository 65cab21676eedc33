#include "schemes/scheme.hpp"

#include <fmt/format.h>

#include <array>

#include "schemes/eulerian.hpp"
#include "schemes/msph.hpp"
#include "schemes/total_lagrangian.hpp"

namespace tektite {
namespace {

struct RegisteredScheme {
  const char* name;
  std::unique_ptr<Scheme> (*make)(const SchemeSetup&);
};

constexpr std::array<RegisteredScheme, 4> schemes{{
    {"eulerian", make_eulerian},
    {"total-lagrangian", make_total_lagrangian},
    {"msph", make_msph},
    {"ssph", make_ssph},
}};

/// [anvil]: axis, at and keep as of a symmetry plane.
std::optional<SymmetryPlane> read_anvil(Section& root, const Scene& scene, bool supported) {
  if (!root.has("anvil")) return std::nullopt;
  auto section = root.section("anvil");
  if (!supported) throw section.fault("", "the scheme knows no anvil", "the scheme msph or ssph");
  const int axis = axis_named(section, "axis", scene.space);
  if (axis == 0 && hoops_of(scene.space) > 0) throw section.fault("axis", "an anvil lies across the axis", "y");
  const double at = section.quantity("at", dimension::length, limits::any, 0.0);
  const std::array<std::string, 2> sides{"above", "below"};
  const double side = section.choice("keep", sides, "above") == "above" ? 1.0 : -1.0;
  section.finish();
  return SymmetryPlane{axis, at, side};
}

}  // namespace

std::vector<std::string> scheme_names() {
  std::vector<std::string> names;
  for (const auto& scheme : schemes) names.emplace_back(scheme.name);
  return names;
}

SchemeSettings read_scheme(Section& root, const Scene& scene) {
  SchemeSettings settings;
  auto section = root.section_or_empty("scheme");
  settings.type = section.choice("type", scheme_names(), "eulerian");
  const bool strong = settings.type == "msph" || settings.type == "ssph";
  settings.courant = section.quantity("courant", dimension::none, {0.0, 1.0, true}, strong ? 0.2 : 0.25);
  if (strong) settings.smoothing_share = section.quantity("smoothing_share", dimension::none, {0.0, 0.5}, 0.3);
  const bool lagrangian = settings.type == "total-lagrangian";
  const std::vector<std::string> corrections =
      lagrangian ? std::vector<std::string>{"mixed", "none"} : std::vector<std::string>{"none"};
  settings.corrected = section.choice("correction", corrections, corrections.front()) == "mixed";
  section.finish();
  settings.kernel = scene.kernel;
  auto smoothing = root.section("smoothing");
  smoothing.choice("kernel", Family<Kernel>::names());
  auto viscosity = root.section_or_empty("viscosity");
  const auto names = Family<Viscosity>::names();
  viscosity.choice("model", names, names.front());
  settings.viscosity = Family<Viscosity>::read(viscosity);
  settings.contact = read_contact(root);
  settings.anvil = read_anvil(root, scene, strong);
  return settings;
}

std::unique_ptr<Scheme> make_scheme(const SchemeSetup& setup) {
  for (const auto& scheme : schemes)
    if (scheme.name == setup.settings.type) return scheme.make(setup);
  throw InputError(fmt::format("unknown scheme \"{}\"", setup.settings.type));
}

}  // namespace tektite
