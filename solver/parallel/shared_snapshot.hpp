#pragma once

#include "core/snapshot.hpp"

namespace tektite {

/// Tells the other ranks what the first one has read: scene, state, bodies and which fields there are. The particles
/// stay where they are until they are dealt (distribution.hpp).
void share_snapshot(Snapshot& snapshot);

}  // namespace tektite
