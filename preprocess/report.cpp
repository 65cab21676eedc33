#include <fmt/format.h>

#include "core/counted.hpp"
#include "preprocess/build_particles.hpp"

namespace tektite::preprocess {
namespace {

const char* mass_unit(Space space) {
  if (space == Space::cylindrical) return "kg/m";
  if (hoops_of(space) > 0) return "kg";
  switch (dimensions_of(space)) {
    case 1:
      return "kg/m2";
    case 2:
      return "kg/m";
    default:
      return "kg";
  }
}

}  // namespace

std::string in_words(const Result& result) {
  const auto space = result.snapshot.particles.space();
  const auto* unit = mass_unit(space);
  std::string text;
  for (const auto& body : result.bodies) {
    text += fmt::format("body {} ({}): {} at a spacing of {:g} m\n", body.name, body.material,
                        counted(body.count, "particle"), body.spacing);
    text += fmt::format("  mass {:.6g} {}", body.mass, unit);
    if (body.exact_mass > 0.0)
      text += fmt::format(", exact {:.6g} {}, difference {:+.3f} %{}", body.exact_mass, unit,
                          100.0 * (body.mass - body.exact_mass) / body.exact_mass,
                          body.mass_spread ? " (spread over the particles)" : "");
    text += '\n';
    if (body.on_symmetry_planes > 0)
      text += fmt::format("  on a symmetry plane, with half their mass a plane: {}\n",
                          counted(body.on_symmetry_planes, "particle"));
    for (const auto& region : body.regions)
      text += fmt::format("  region {}: {}, {}\n", region.name, counted(region.count, "particle"), region.words);
    for (const auto& remark : body.remarks) text += fmt::format("  repaired: {}\n", remark);
    for (const auto& warning : body.warnings) text += fmt::format("  warning: {}\n", warning);
  }
  return text + fmt::format("{} in all, {}\n", counted(result.count(), "particle"), name_of(space));
}

}  // namespace tektite::preprocess
