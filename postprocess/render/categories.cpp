#include "postprocess/render/categories.hpp"

namespace tektite {
namespace {

constexpr Colour dark{0.20, 0.33, 0.60};
constexpr Colour light{0.98, 0.78, 0.40};

}  // namespace

std::optional<std::vector<Category>> categories_of(const std::string& field, const Whole& whole) {
  if (field == "kernel_type") return std::vector<Category>{{"total Lagrangian", dark}, {"Eulerian", light}};
  if (field == "clamped") return std::vector<Category>{{"free", light}, {"clamped", dark}};
  if (field != "body") return std::nullopt;
  std::vector<Category> bodies;
  for (const auto& body : whole.bodies) bodies.push_back({body.name, distinct_colour(bodies.size())});
  return bodies;
}

}  // namespace tektite
