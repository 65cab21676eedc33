// What is written for ParaView is read back with VTK's own reader, field by field.

#include "postprocess/export/vtu.hpp"

#include <vtkDataArray.h>
#include <vtkFieldData.h>
#include <vtkInformation.h>
#include <vtkInformationStringKey.h>
#include <vtkPointData.h>
#include <vtkSmartPointer.h>
#include <vtkStringArray.h>
#include <vtkUnstructuredGrid.h>
#include <vtkXMLUnstructuredGridReader.h>

#include <catch2/catch.hpp>
#include <filesystem>
#include <fstream>
#include <sstream>

#include "core/error.hpp"
#include "postprocess/export/grid.hpp"
#include "support/apart.hpp"
#include "support/particles.hpp"
#include "support/temporary_folder.hpp"

namespace tektite::test {
namespace {

vtkSmartPointer<vtkUnstructuredGrid> written_and_read(const Snapshot& snapshot) {
  const TemporaryFolder folder;
  write_vtu(make_grid(snapshot), folder.file("vtu/000000.vtu"));
  const auto reader = vtkSmartPointer<vtkXMLUnstructuredGridReader>::New();
  reader->SetFileName(folder.file("vtu/000000.vtu").c_str());
  reader->Update();
  return reader->GetOutput();
}

int components_in_file(const FieldInfo& row, int dimensions) {
  if (row.rank == Rank::vector) return 3;
  if (row.rank == Rank::symmetric) return 6;
  return row.rank == Rank::tensor ? dimensions * dimensions : 1;
}

double value_in(const Particles& particles, const FieldInfo& row, std::size_t i, int component) {
  const int width = particles.components(row.field);
  if (component >= width) return 0.0;
  const auto place = i * static_cast<std::size_t>(width) + static_cast<std::size_t>(component);
  return row.rank == Rank::integer ? static_cast<double>(particles.integers(row.field)[place])
                                   : particles.reals(row.field)[place];
}

}  // namespace

TEST_CASE("VTU: every result field is there with its values and its unit, in every space") {
  for (const auto& [space, name] : space_names) {
    const Snapshot snapshot{filled_particles(space), {{"time", 1.5e-6}}, ""};
    const auto grid = written_and_read(snapshot);
    REQUIRE(grid->GetNumberOfPoints() == 7);
    REQUIRE(grid->GetNumberOfCells() == 7);
    for (const auto& row : field_table) {
      if (row.keep != Keep::result) continue;
      INFO(name << ": " << row.name);
      auto* array = grid->GetPointData()->GetArray(std::string(row.name).c_str());
      REQUIRE(array);
      CHECK(array->GetInformation()->Get(vtkDataArray::UNITS_LABEL()) == std::string(row.unit));
      REQUIRE(array->GetNumberOfComponents() == components_in_file(row, dimensions_of(space)));
      for (vtkIdType i = 0; i < 7; ++i)
        for (int k = 0; k < array->GetNumberOfComponents(); ++k)
          CHECK(array->GetComponent(i, k) == value_in(snapshot.particles, row, static_cast<std::size_t>(i), k));
    }
  }
}

TEST_CASE("VTU: body, body names, time and von Mises stress are there, stress components have names") {
  auto particles = filled_particles(Space::plane_strain);
  auto stress = particles.reals(Field::deviatoric_stress).first(4);
  stress[0] = 2.0;
  stress[1] = -1.0;
  stress[2] = -1.0;
  stress[3] = 4.0;
  const auto grid = written_and_read({particles, {{"time", 1.5e-6}}, ""});
  CHECK(grid->GetFieldData()->GetArray("TimeValue")->GetComponent(0, 0) == 1.5e-6);
  const auto* names = vtkStringArray::SafeDownCast(grid->GetFieldData()->GetAbstractArray("body_names"));
  REQUIRE(names);
  CHECK(const_cast<vtkStringArray*>(names)->GetValue(1) == "right");
  CHECK(grid->GetPointData()->GetArray("body")->GetComponent(2, 0) == 0.0);
  CHECK(grid->GetPointData()->GetArray("body")->GetComponent(3, 0) == 1.0);
  // √(3/2 (4 + 1 + 1 + 2·16)) = √57
  CHECK(grid->GetPointData()->GetArray("von_mises_stress")->GetComponent(0, 0) == Approx(std::sqrt(57.0)));
  CHECK(grid->GetPointData()->GetArray("deviatoric_stress")->GetComponentName(3) == std::string("XY"));
}

TEST_CASE("PVD: times keep all their digits") {
  const TemporaryFolder folder;
  const double time = 1.0 / 3.0 * 1e-6;
  write_pvd({{0.0, "vtu/000000.vtu"}, {time, "vtu/000001.vtu"}}, folder.file("run.pvd"));
  std::ostringstream text;
  text << std::ifstream(folder.file("run.pvd")).rdbuf();
  const auto at = text.str().rfind("timestep=\"") + 10;
  CHECK(std::stod(text.str().substr(at)) == time);
  CHECK(text.str().find("file=\"vtu/000001.vtu\"") != std::string::npos);
}

TEST_CASE("VTU: a place that cannot be written to is a RunError") {
  const Snapshot snapshot{filled_particles(Space::line), {{"time", 0.0}}, ""};
  CHECK_THROWS_AS(write_vtu(make_grid(snapshot), "/proc/no-such-folder/0.vtu"), RunError);
  const TemporaryFolder folder;
  const auto path = folder.file("0.vtu");
  CHECK_THAT(fault_apart([&] {
               leave_room(100);
               write_vtu(make_grid(snapshot), path);
             }),
             Catch::StartsWith(path + ": cannot be written: "));
  CHECK(std::filesystem::is_empty(folder.path()));
}

}  // namespace tektite::test
