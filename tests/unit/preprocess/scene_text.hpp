#pragma once
// Shapes, arrangements and scenes from a line of TOML.

#include <string>

#include "core/document.hpp"
#include "preprocess/arrangement/registry.hpp"
#include "preprocess/build_particles.hpp"
#include "preprocess/geometry/registry.hpp"

namespace tektite::test {

inline preprocess::ShapePointer shape_of(const std::string& table, int dimensions) {
  auto document = Document::parse("shape = " + table, "scene.toml");
  return preprocess::read_shape(document.root().section("shape"), dimensions);
}

inline preprocess::ArrangementChoice arrangement_of(const std::string& table, int dimensions) {
  auto document = Document::parse("arrangement = " + table, "scene.toml");
  return preprocess::read_arrangement(document.root().section("arrangement"), dimensions);
}

/// Number of particles of a shape in an arrangement; checks on the way that count() agrees with fill().
inline std::size_t count_of(const std::string& shape, const std::string& arrangement, int dimensions, double spacing) {
  const auto filled = shape_of(shape, dimensions);
  const auto choice = arrangement_of(arrangement, dimensions);
  const auto count = choice.arrangement->fill(*filled, spacing, {}).positions.size();
  return choice.arrangement->count(*filled, spacing) == count ? count : 0;
}

/// The result of a scene whose head (name, space, one material) is given here.
inline preprocess::Result result_of(const std::string& space, const std::string& rest) {
  auto document = Document::parse("name = 'test'\nspace = '" + space + "'\nspacing = 0.1\n" + rest +
                                      "\n[material.unit]\ndensity = 1.0\n[material.other]\ndensity = 2.0\n",
                                  "scene.toml");
  return preprocess::build_particles(document);
}

}  // namespace tektite::test
