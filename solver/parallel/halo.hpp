#pragma once

#include "core/fields.hpp"

namespace tektite {

/// The particles of other ranks that are nearer than `width` in m to one of this rank, by these places.
struct Halo {
  double width = 0.0;
  Field places = Field::position;
};

}  // namespace tektite
