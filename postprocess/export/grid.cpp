#include "postprocess/export/grid.hpp"

#include <vtkCellArray.h>
#include <vtkCellType.h>
#include <vtkDoubleArray.h>
#include <vtkFieldData.h>
#include <vtkInformation.h>
#include <vtkInformationStringKey.h>
#include <vtkPointData.h>
#include <vtkPoints.h>
#include <vtkStringArray.h>
#include <vtkTypeInt64Array.h>
#include <vtkUnstructuredGrid.h>

#include <numeric>

#include "postprocess/scalar_field.hpp"

namespace tektite {
namespace {

int components_in_vtk(Rank rank, int dimensions) {
  switch (rank) {
    case Rank::vector:
      return 3;
    case Rank::symmetric:
      return 6;
    case Rank::tensor:
      return dimensions * dimensions;
    default:
      return 1;
  }
}

void name_components(vtkDataArray* array, Rank rank) {
  constexpr const char* axes[] = {"X", "Y", "Z"};
  constexpr const char* pairs[] = {"XX", "YY", "ZZ", "XY", "YZ", "XZ"};
  if (rank == Rank::vector)
    for (int k = 0; k < 3; ++k) array->SetComponentName(k, axes[k]);
  if (rank == Rank::symmetric)
    for (int k = 0; k < 6; ++k) array->SetComponentName(k, pairs[k]);
}

/// `values` (count x given) with zeros behind each row up to the components that VTK expects.
template <class Array, class Value>
vtkSmartPointer<Array> padded(std::span<const Value> values, int given, int wanted) {
  const auto count = values.size() / static_cast<std::size_t>(given);
  auto array = vtkSmartPointer<Array>::New();
  array->SetNumberOfComponents(wanted);
  array->SetNumberOfTuples(static_cast<vtkIdType>(count));
  auto* out = array->GetPointer(0);
  for (std::size_t i = 0; i < count; ++i)
    for (int k = 0; k < wanted; ++k)
      *out++ = k < given ? values[i * static_cast<std::size_t>(given) + static_cast<std::size_t>(k)] : Value{};
  return array;
}

void add(vtkUnstructuredGrid* grid, vtkDataArray* array, std::string_view name, std::string_view unit) {
  array->SetName(std::string(name).c_str());
  array->GetInformation()->Set(vtkDataArray::UNITS_LABEL(), std::string(unit).c_str());
  grid->GetPointData()->AddArray(array);
}

void add_field(vtkUnstructuredGrid* grid, const Particles& particles, const FieldInfo& row) {
  const int given = particles.components(row.field);
  const int wanted = components_in_vtk(row.rank, particles.dimensions());
  const auto size = particles.count() * static_cast<std::size_t>(given);
  if (row.rank == Rank::integer) {
    add(grid, padded<vtkTypeInt64Array>(particles.integers(row.field).first(size), given, wanted), row.name, row.unit);
    return;
  }
  const auto array = padded<vtkDoubleArray>(particles.reals(row.field).first(size), given, wanted);
  name_components(array, row.rank);
  add(grid, array, row.name, row.unit);
}

void add_bodies(vtkUnstructuredGrid* grid, const Particles& particles) {
  const auto index = vtkSmartPointer<vtkTypeInt64Array>::New();
  index->SetNumberOfTuples(static_cast<vtkIdType>(particles.count()));
  const auto names = vtkSmartPointer<vtkStringArray>::New();
  names->SetName("body_names");
  for (std::size_t k = 0; k < particles.bodies().size(); ++k) {
    const auto& body = particles.bodies()[k];
    names->InsertNextValue(body.name);
    for (auto i = body.range.begin; i < body.range.end; ++i)
      index->SetValue(static_cast<vtkIdType>(i), static_cast<vtkTypeInt64>(k));
  }
  add(grid, index, "body", "1");
  grid->GetFieldData()->AddArray(names);
}

void add_cells(vtkUnstructuredGrid* grid, std::size_t count) {
  const auto numbered = [](std::size_t size) {
    const auto array = vtkSmartPointer<vtkTypeInt64Array>::New();
    array->SetNumberOfValues(static_cast<vtkIdType>(size));
    std::iota(array->GetPointer(0), array->GetPointer(0) + size, vtkTypeInt64{0});
    return array;
  };
  const auto cells = vtkSmartPointer<vtkCellArray>::New();
  cells->SetData(numbered(count + 1), numbered(count));
  grid->SetCells(VTK_VERTEX, cells);
}

}  // namespace

const FieldSet& exported_fields() {
  static const FieldSet fields = [] {
    FieldSet results;
    for (const auto& row : field_table)
      if (row.keep == Keep::result) results.insert(row.field);
    return results;
  }();
  return fields;
}

vtkSmartPointer<vtkUnstructuredGrid> make_grid(Snapshot snapshot) {
  auto& particles = snapshot.particles;
  auto grid = vtkSmartPointer<vtkUnstructuredGrid>::New();
  const auto points = vtkSmartPointer<vtkPoints>::New();
  const auto width = particles.dimensions();
  const std::span<const double> places = particles.reals(Field::position);
  points->SetData(padded<vtkDoubleArray>(places.first(particles.count() * static_cast<std::size_t>(width)), width, 3));
  grid->SetPoints(points);
  add_cells(grid, particles.count());
  std::vector<double> equivalent;
  if (particles.has(Field::deviatoric_stress)) equivalent = von_mises_stress(particles);
  for (const auto field : exported_fields()) {
    if (particles.has(field)) add_field(grid, particles, info(field));
    particles.release(field);
  }
  if (!equivalent.empty())
    add(grid, padded<vtkDoubleArray>(std::span<const double>(equivalent), 1, 1), "von_mises_stress",
        info(Field::deviatoric_stress).unit);
  add_bodies(grid, particles);
  const auto time = vtkSmartPointer<vtkDoubleArray>::New();
  time->SetName("TimeValue");
  time->InsertNextValue(snapshot.time());
  grid->GetFieldData()->AddArray(time);
  return grid;
}

}  // namespace tektite
