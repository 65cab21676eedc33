#include <fmt/format.h>

#include "preprocess/build_particles.hpp"

namespace tektite::preprocess {
namespace {

const char* mass_unit(Space space) {
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
  const auto& particles = result.snapshot.particles;
  const auto* unit = mass_unit(particles.space());
  std::string text;
  for (const auto& body : result.bodies) {
    const double difference = 100.0 * (body.mass - body.exact_mass) / body.exact_mass;
    text += fmt::format("body {} ({}): {} particles at a spacing of {:g} m\n", body.name, body.material, body.count,
                        body.spacing);
    text += fmt::format("  mass {:.6g} {}, exact {:.6g} {}, difference {:+.3f} %{}\n", body.mass, unit, body.exact_mass,
                        unit, difference, body.mass_spread ? " (spread over the particles)" : "");
    if (body.on_symmetry_planes > 0)
      text += fmt::format("  {} particles lie on a symmetry plane, with half their mass a plane\n",
                          body.on_symmetry_planes);
    for (const auto& region : body.regions)
      text += fmt::format("  region {}: {} particles, {}\n", region.name, region.count, region.words);
    for (const auto& remark : body.remarks) text += fmt::format("  repaired: {}\n", remark);
  }
  return text + fmt::format("{} particles in all, {}\n", particles.count(), name_of(particles.space()));
}

}  // namespace tektite::preprocess
