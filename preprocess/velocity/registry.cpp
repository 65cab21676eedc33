#include <array>

#include "preprocess/velocity/velocity.hpp"

namespace tektite::preprocess {
namespace {

struct VelocityRow {
  const char* name;
  VelocityPointer (*read)(Section&, Space);
};

constexpr std::array<VelocityRow, 5> velocities{{
    {"uniform", read_uniform},
    {"radial", read_radial},
    {"radial-inverse", read_radial_inverse},
    {"rotation", read_rotation},
    {"pulse", read_pulse},
}};

}  // namespace

VelocityPointer read_velocity(Section& body, Space space) {
  if (!body.has_table("velocity")) return read_uniform(body, space);
  auto section = body.section("velocity");
  std::vector<std::string> names;
  for (const auto& row : velocities) names.emplace_back(row.name);
  const auto type = section.choice("type", names);
  VelocityPointer velocity;
  for (const auto& row : velocities)
    if (row.name == type) velocity = row.read(section, space);
  section.finish();
  return velocity;
}

}  // namespace tektite::preprocess
