#pragma once
// A snapshot as a VTK grid: one vertex cell a particle, one array a result field, each with its unit.

#include <vtkSmartPointer.h>

#include "core/snapshot.hpp"

class vtkUnstructuredGrid;

namespace tektite {

/// The fields of a particle file that make_grid() takes.
const FieldSet& exported_fields();

/// Vectors have three components and symmetric tensors six (XX YY ZZ XY YZ XZ), as VTK and ParaView expect. Derived:
/// von_mises_stress and the index of the body; the bodies' names and the time are field data. The unit of an array is
/// its vtkDataArray::UNITS_LABEL. Of what is moved into it, each field goes as it has become an array.
vtkSmartPointer<vtkUnstructuredGrid> make_grid(Snapshot snapshot);

}  // namespace tektite
