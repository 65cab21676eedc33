#pragma once
// What postprocess reads of a scene: its own tables, and the names of bodies and probes that they may mention.

#include "core/scene.hpp"
#include "postprocess/measure/measure.hpp"
#include "postprocess/render/picture.hpp"

namespace tektite {

struct Plan {
  Scene scene;
  Declared declared;
  std::vector<NamedMeasure> measures;
  std::vector<Picture> pictures;  ///< empty where the scene asks for none
};

/// Reads [measure.*] and [picture.*] and leaves the other stages' tables. Throws InputError.
Plan read_plan(Document& document);

}  // namespace tektite
