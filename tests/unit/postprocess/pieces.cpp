// A large particle file becomes several pieces, which VTK's own reader joins to what one file would have held.

#include "postprocess/export/pieces.hpp"

#include <vtkDataArray.h>
#include <vtkFieldData.h>
#include <vtkInformation.h>
#include <vtkInformationDoubleVectorKey.h>
#include <vtkInformationStringKey.h>
#include <vtkPointData.h>
#include <vtkSmartPointer.h>
#include <vtkStreamingDemandDrivenPipeline.h>
#include <vtkStringArray.h>
#include <vtkUnstructuredGrid.h>
#include <vtkXMLPUnstructuredGridReader.h>

#include <catch2/catch.hpp>
#include <filesystem>
#include <fstream>

#include "postprocess/export/grid.hpp"
#include "support/particles.hpp"
#include "support/temporary_folder.hpp"

namespace tektite::test {
namespace {

namespace fs = std::filesystem;

std::string file_of_seven(const TemporaryFolder& folder, Space space) {
  const auto path = folder.file("000012.h5");
  write_snapshot({filled_particles(space), {{"time", 1.0 / 3.0 * 1e-6}}, ""}, path);
  return path;
}

vtkSmartPointer<vtkXMLPUnstructuredGridReader> read_joined(const std::string& path) {
  auto reader = vtkSmartPointer<vtkXMLPUnstructuredGridReader>::New();
  reader->SetFileName(path.c_str());
  reader->Update();
  return reader;
}

void check_same(vtkDataArray* ours, vtkDataArray* wanted) {
  REQUIRE(ours);
  INFO(wanted->GetName());
  REQUIRE(ours->GetDataType() == wanted->GetDataType());
  REQUIRE(ours->GetNumberOfComponents() == wanted->GetNumberOfComponents());
  REQUIRE(ours->GetNumberOfTuples() == wanted->GetNumberOfTuples());
  for (int k = 0; k < wanted->GetNumberOfComponents(); ++k) {
    if (wanted->GetComponentName(k)) CHECK(ours->GetComponentName(k) == std::string(wanted->GetComponentName(k)));
    for (vtkIdType i = 0; i < wanted->GetNumberOfTuples(); ++i)
      CHECK(ours->GetComponent(i, k) == wanted->GetComponent(i, k));
  }
}

std::vector<std::string> names_in(const fs::path& folder) {
  std::vector<std::string> names;
  for (const auto& entry : fs::directory_iterator(folder)) names.push_back(entry.path().filename().string());
  std::ranges::sort(names);
  return names;
}

}  // namespace

TEST_CASE("Pieces: joined they are the grid of the whole file, with units, names and time") {
  const auto space = GENERATE(Space::line, Space::plane_strain, Space::solid);
  const TemporaryFolder folder;
  const auto file = file_of_seven(folder, space);
  const auto told = export_particles(file, folder.file("vtu"), 3);  // a body ends with the first, another in the third
  CHECK(told.time == 1.0 / 3.0 * 1e-6);
  CHECK(told.path == "000012.pvtu");
  CHECK(names_in(folder.file("vtu/000012")) == std::vector<std::string>{"0000.vtu", "0001.vtu", "0002.vtu"});
  const auto wanted = make_grid(read_snapshot(file));
  const auto reader = read_joined(folder.file("vtu/000012.pvtu"));
  auto* grid = reader->GetOutput();
  REQUIRE(grid->GetNumberOfPoints() == 7);
  CHECK(grid->GetNumberOfCells() == 7);
  check_same(grid->GetPoints()->GetData(), wanted->GetPoints()->GetData());
  REQUIRE(grid->GetPointData()->GetNumberOfArrays() == wanted->GetPointData()->GetNumberOfArrays());
  for (int k = 0; k < wanted->GetPointData()->GetNumberOfArrays(); ++k) {
    auto* array = wanted->GetPointData()->GetArray(k);
    auto* ours = grid->GetPointData()->GetArray(array->GetName());
    check_same(ours, array);
    CHECK(ours->GetInformation()->Get(vtkDataArray::UNITS_LABEL()) ==
          std::string(array->GetInformation()->Get(vtkDataArray::UNITS_LABEL())));
  }
  auto* names = vtkStringArray::SafeDownCast(grid->GetFieldData()->GetAbstractArray("body_names"));
  REQUIRE(names);
  CHECK(names->GetNumberOfValues() == 2);
  auto* information = reader->GetOutputInformation(0);
  REQUIRE(information->Has(vtkStreamingDemandDrivenPipeline::TIME_STEPS()));
  CHECK(information->Get(vtkStreamingDemandDrivenPipeline::TIME_STEPS())[0] == told.time);
}

TEST_CASE("Pieces: what fits into one is one file") {
  const TemporaryFolder folder;
  const auto file = file_of_seven(folder, Space::plane_strain);
  CHECK(export_particles(file, folder.file("vtu"), 7).path == "000012.vtu");
  CHECK(names_in(folder.file("vtu")) == std::vector<std::string>{"000012.vtu"});
}

TEST_CASE("Pieces: those of an older export do not stay, nor does the one file, nor they beside it") {
  const TemporaryFolder folder;
  const auto file = file_of_seven(folder, Space::plane_strain);
  const auto vtu = folder.file("vtu");
  export_particles(file, vtu);
  export_particles(file, vtu, 1);
  CHECK(names_in(vtu) == std::vector<std::string>{"000012", "000012.pvtu"});
  CHECK(names_in(vtu + "/000012").size() == 7);
  std::ofstream(vtu + "/000012/0001.vtu.part") << "of a process that was killed";
  export_particles(file, vtu, 4);
  CHECK(names_in(vtu + "/000012") == std::vector<std::string>{"0000.vtu", "0001.vtu"});
  CHECK(read_joined(vtu + "/000012.pvtu")->GetOutput()->GetNumberOfPoints() == 7);
  export_particles(file, vtu);
  CHECK(names_in(vtu) == std::vector<std::string>{"000012.vtu"});
}

}  // namespace tektite::test
