#include "postprocess/render/particle_actors.hpp"

#include <vtkActor.h>
#include <vtkConeSource.h>
#include <vtkDoubleArray.h>
#include <vtkGlyph3DMapper.h>
#include <vtkPointData.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>
#include <vtkProperty.h>
#include <vtkScalarsToColors.h>
#include <vtkSphereSource.h>

#include <numbers>

namespace tektite {
namespace {

/// Seen from above, the nearest of several overlapping cones hides the others: that draws the Voronoi cells.
vtkSmartPointer<vtkPolyDataAlgorithm> cell_of_unit_spacing() {
  auto cone = vtkSmartPointer<vtkConeSource>::New();
  cone->SetDirection(0.0, 0.0, 1.0);
  cone->SetHeight(1.0);
  cone->SetRadius(1.0 / std::numbers::sqrt2);
  cone->SetResolution(16);
  cone->CappingOff();
  return cone;
}

vtkSmartPointer<vtkPolyDataAlgorithm> sphere_of_unit_spacing() {
  auto sphere = vtkSmartPointer<vtkSphereSource>::New();
  sphere->SetRadius(0.5);
  sphere->SetThetaResolution(12);
  sphere->SetPhiResolution(8);
  return sphere;
}

}  // namespace

vtkSmartPointer<vtkActor> particle_actor(const Whole& whole, const std::vector<bool>& drawn,
                                         const std::vector<double>& values, vtkScalarsToColors* colours) {
  const auto points = vtkSmartPointer<vtkPoints>::New();
  points->SetDataTypeToDouble();
  const auto size = vtkSmartPointer<vtkDoubleArray>::New();
  size->SetName("size");
  const auto value = vtkSmartPointer<vtkDoubleArray>::New();
  value->SetName("value");
  for (std::size_t i = 0; i < whole.count(); ++i) {
    if (!drawn[i]) continue;
    points->InsertNextPoint(whole.position[i].c);
    size->InsertNextValue(whole.bodies[static_cast<std::size_t>(whole.body[i])].spacing);
    value->InsertNextValue(values[i]);
  }
  const auto data = vtkSmartPointer<vtkPolyData>::New();
  data->SetPoints(points);
  data->GetPointData()->AddArray(size);
  data->GetPointData()->SetScalars(value);

  const bool flat = whole.dimensions < 3;
  const auto mapper = vtkSmartPointer<vtkGlyph3DMapper>::New();
  mapper->SetInputData(data);
  mapper->SetSourceConnection((flat ? cell_of_unit_spacing() : sphere_of_unit_spacing())->GetOutputPort());
  mapper->SetScaleModeToScaleByMagnitude();
  mapper->SetScaleArray("size");
  mapper->SetLookupTable(colours);
  mapper->UseLookupTableScalarRangeOn();
  mapper->ScalarVisibilityOn();
  auto actor = vtkSmartPointer<vtkActor>::New();
  actor->SetMapper(mapper);
  if (flat) actor->GetProperty()->LightingOff();
  return actor;
}

}  // namespace tektite
