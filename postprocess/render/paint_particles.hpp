#pragma once
// Particles as things to see.

#include <vector>

#include "postprocess/render/canvas.hpp"
#include "postprocess/render/framing.hpp"

namespace tektite {

/// Paints the particles that `drawn` picks on the part `frame` of the canvas, each of its own colour. In space they are
/// spheres of the size of the spacing with the light behind the camera. In the plane they are flat cells: a particle
/// owns what is nearer to it than to any other, as far as a lattice of its spacing reaches (√½ δ), so an undeformed
/// body shows no holes and a stretched one does.
void paint_particles(Canvas& canvas, const Frame& frame, const Camera& camera, const Whole& whole,
                     const std::vector<bool>& drawn, const std::vector<Colour>& colours);

}  // namespace tektite
