#pragma once
// Particles as things to see.

#include <vtkSmartPointer.h>

#include <vector>

#include "postprocess/whole.hpp"

class vtkActor;
class vtkScalarsToColors;

namespace tektite {

/// The particles that `drawn` picks, coloured by `values` (one a particle of `whole`). In space they are shaded spheres
/// of the size of the spacing. In the plane they are flat cells: a particle owns what is nearer to it than to any
/// other, as far as a lattice of its spacing reaches (√½ δ), so an undeformed body shows no holes and a stretched one
/// does.
vtkSmartPointer<vtkActor> particle_actor(const Whole& whole, const std::vector<bool>& drawn,
                                         const std::vector<double>& values, vtkScalarsToColors* colours);

}  // namespace tektite
