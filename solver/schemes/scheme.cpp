#include "schemes/scheme.hpp"

#include <array>
#include <stdexcept>

#include "schemes/eulerian.hpp"
#include "schemes/godunov_pm.hpp"
#include "schemes/godunov_settings.hpp"
#include "schemes/godunov_split.hpp"
#include "schemes/msph.hpp"
#include "schemes/total_lagrangian.hpp"

namespace tektite {
namespace {

struct RegisteredScheme {
  const char* name;
  std::unique_ptr<Scheme> (*make)(const SchemeSetup&);
};

constexpr std::array<RegisteredScheme, 7> schemes{{
    {"adaptle", make_total_lagrangian},
    {"eulerian", make_eulerian},
    {"godunov-pm", make_godunov_pm},
    {"godunov-split", make_godunov_split},
    {"total-lagrangian", make_total_lagrangian},
    {"msph", make_msph},
    {"ssph", make_ssph},
}};

/// What the keys of [scheme] hang on.
struct Kind {
  bool eulerian, total_lagrangian, adaptle, split, strong;

  explicit Kind(const std::string& type)
      : eulerian(type == "eulerian"),
        total_lagrangian(type == "total-lagrangian"),
        adaptle(type == "adaptle"),
        split(type == "godunov-split"),
        strong(type == "msph" || type == "ssph") {}
  bool lagrangian() const { return total_lagrangian || adaptle; }
  bool viscous() const { return eulerian || lagrangian(); }
};

/// Of `adaptle` the plain one: a pair of both kinds of particles has no gradient that both see.
Viscosity read_viscosity(Section& root, const Kind& kind) {
  auto section = root.section_or_empty("viscosity");
  auto names = Family<Viscosity>::names();
  if (kind.adaptle) names = {std::string(MonaghanViscosity::name)};
  section.choice("model", names, names.front());
  return Family<Viscosity>::read(section);
}

/// The keys `correction`, `correction_limit` and `artificial_stress`. Eulerian kernels are not corrected unasked, since
/// their corrections are those of a step, and make it three times as dear.
void read_correction(Section& section, const Kind& kind, Space space, SchemeSettings& settings) {
  std::vector<std::string> corrections{kind.lagrangian() ? "mixed" : "none"};
  if (kind.lagrangian()) corrections.emplace_back("none");
  if (kind.eulerian || kind.split) corrections.emplace_back("mixed");
  if (kind.adaptle) corrections.emplace_back("reference");  // of what is total-Lagrangian alone
  const auto correction = section.choice("correction", corrections, kind.adaptle ? "reference" : corrections.front());
  settings.corrected = kind.lagrangian() && correction != "none";
  settings.corrected_eulerian = (kind.eulerian || kind.adaptle || kind.split) && correction == "mixed";
  if (settings.corrected_eulerian && section.has("correction_limit"))
    settings.correction_limit = section.quantity("correction_limit", dimension::none, {1.0, limits::infinite, true});
  if (section.has("artificial_stress") && (kind.eulerian || kind.adaptle))
    settings.artificial_stress = read_artificial_stress(section.section("artificial_stress"), space, kind.adaptle);
}

/// The key `hourglass_control`; zero where it is left out.
double read_hourglass_control(Section& section, const Kind& kind, const std::string& type) {
  if (!section.has("hourglass_control")) return 0.0;
  if (!kind.total_lagrangian)
    throw section.fault("hourglass_control",
                        "it holds bonds of the reference configuration, which " + type + " lets go of or has none of",
                        "the scheme total-lagrangian");
  return section.quantity("hourglass_control", dimension::none, {0.0, 1.0});
}

/// [anvil]: axis, at and keep as of a symmetry plane.
std::optional<SymmetryPlane> read_anvil(Section& root, const Scene& scene, bool supported) {
  if (!root.has("anvil")) return std::nullopt;
  auto section = root.section("anvil");
  if (!supported)
    throw section.fault("", "the scheme knows no anvil", "the scheme eulerian, total-lagrangian, msph or ssph");
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
  const Kind kind(settings.type);
  settings.courant = section.quantity("courant", dimension::none, {0.0, 1.0, true}, kind.strong ? 0.2 : 0.25);
  if (kind.strong) {
    const std::array<std::string, 2> forces{"strong", "adjoint"};
    settings.smoothing_share = section.quantity("smoothing_share", dimension::none, {0.0, 0.5}, 0.3);
    settings.adjoint_forces = section.choice("forces", forces, "strong") == "adjoint";
  }
  read_correction(section, kind, scene.space, settings);
  if (kind.adaptle) settings.conversion = read_conversion(section);
  settings.hourglass_control = read_hourglass_control(section, kind, settings.type);
  if (kind.split) settings.godunov = std::make_shared<GodunovSettings>(read_godunov(section, scene.space));
  section.finish();
  settings.kernel = scene.kernel;
  auto smoothing = root.section("smoothing");
  smoothing.choice("kernel", Family<Kernel>::names());
  if (kind.viscous()) settings.viscosity = read_viscosity(root, kind);
  settings.contact = read_contact(root, kind.lagrangian());
  settings.anvil = read_anvil(root, scene, kind.strong || kind.eulerian || kind.total_lagrangian);
  return settings;
}

std::unique_ptr<Scheme> make_scheme(const SchemeSetup& setup) {
  for (const auto& scheme : schemes)
    if (scheme.name == setup.settings.type) return scheme.make(setup);
  throw std::logic_error("read_scheme() lets no unknown scheme through");
}

}  // namespace tektite
