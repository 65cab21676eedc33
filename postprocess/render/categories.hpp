#pragma once
// Fields whose numbers stand for names: they are drawn in one colour a name, with a legend.

#include <optional>
#include <string>
#include <vector>

#include "postprocess/render/colours.hpp"
#include "postprocess/whole.hpp"

namespace tektite {

struct Category {
  std::string name;
  Colour colour;
};

/// The names that the numbers 0, 1, 2, ... of a field stand for, with their colours: the bodies of `whole`, the kernel
/// types (total-Lagrangian dark, Eulerian light) and whether a particle is clamped; nullopt for a field of quantities.
std::optional<std::vector<Category>> categories_of(const std::string& field, const Whole& whole);

}  // namespace tektite
