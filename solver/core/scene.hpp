#pragma once
// What every stage needs of a scene, and which stage owns which key. A stage reads its own keys, leaves those of the
// others, and so an unknown key is found by the stage that would own it.

#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "core/document.hpp"
#include "core/space.hpp"

namespace tektite {

enum class Stage { preprocess, solve, postprocess };

struct SymmetryPlane {
  int axis = 0;       ///< normal to the plane: 0 = x, 1 = y, 2 = z
  double at = 0.0;    ///< in m
  double side = 1.0;  ///< +1: the body lies where the coordinate is larger
};

struct Scene {
  std::string name;
  std::string title;
  Space space = Space::line;
  double smoothing_ratio = 0.0;  ///< h/δ
  std::string kernel;
  std::vector<SymmetryPlane> symmetry;  ///< the axis x = 0 of a radial space is one of them
};

/// Reads what is common to all stages and leaves the top-level keys that `stage` does not own.
/// Postcondition: root.finish() succeeds once the stage has read its own keys.
Scene read_scene(Section& root, Stage stage);

/// Leaves the keys of a [body.NAME] or [material.NAME] that another stage owns.
void leave_others(Section& section, Stage stage);

/// Names that are allowed for axes in this space: x, y, z.
int axis_named(Section& section, const std::string& key, Space space);

}  // namespace tektite
