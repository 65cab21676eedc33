#include "postprocess/export/vtu.hpp"

#include <fmt/format.h>
#include <vtkCallbackCommand.h>
#include <vtkDataArray.h>
#include <vtkErrorCode.h>
#include <vtkExecutive.h>
#include <vtkFieldData.h>
#include <vtkInformation.h>
#include <vtkInformationStringKey.h>
#include <vtkPointData.h>
#include <vtkPoints.h>
#include <vtkUnstructuredGrid.h>
#include <vtkXMLUnstructuredGridWriter.h>

#include "core/error.hpp"
#include "core/write_beside.hpp"

namespace tektite {
namespace {

/// How a file of pieces tells an array: type, name, components, and its unit where it has one.
std::string array_of_pieces(vtkDataArray* array) {
  std::string text = fmt::format("      <PDataArray type=\"{}\" Name=\"{}\" NumberOfComponents=\"{}\"",
                                 array->GetDataType() == VTK_DOUBLE ? "Float64" : "Int64", array->GetName(),
                                 array->GetNumberOfComponents());
  for (int k = 0; k < array->GetNumberOfComponents(); ++k)
    if (const char* name = array->GetComponentName(k)) text += fmt::format(" ComponentName{}=\"{}\"", k, name);
  const char* unit = array->HasInformation() ? array->GetInformation()->Get(vtkDataArray::UNITS_LABEL()) : nullptr;
  if (!unit) return text + "/>\n";
  return text + fmt::format(
                    ">\n        <InformationKey name=\"UNITS_LABEL\" location=\"vtkDataArray\">{}</InformationKey>\n"
                    "      </PDataArray>\n",
                    unit);
}

}  // namespace

void write_vtu(vtkUnstructuredGrid* grid, const std::string& path) {
  write_beside(path, [&](const std::string& beside) {
    const auto writer = vtkSmartPointer<vtkXMLUnstructuredGridWriter>::New();
    writer->SetFileName(beside.c_str());
    writer->SetInputData(grid);
    writer->SetDataModeToAppended();
    writer->EncodeAppendedDataOff();
    writer->SetCompressorTypeToLZ4();  // a twentieth of zlib's time for a fifth more bytes
    const auto silence = vtkSmartPointer<vtkCallbackCommand>::New();  // what goes wrong is told by us
    writer->AddObserver(vtkCommand::ErrorEvent, silence);
    writer->GetExecutive()->AddObserver(vtkCommand::ErrorEvent, silence);
    if (writer->Write() != 1 || writer->GetErrorCode() != 0)
      throw RunError(
          fmt::format("{}: cannot be written: {}", path, vtkErrorCode::GetStringFromErrorCode(writer->GetErrorCode())));
  });
}

void write_pvtu(vtkUnstructuredGrid* grid, const std::vector<std::string>& pieces, const std::string& path) {
  const double time = grid->GetFieldData()->GetArray("TimeValue")->GetComponent(0, 0);
  std::string text =
      "<?xml version=\"1.0\"?>\n<VTKFile type=\"PUnstructuredGrid\" version=\"0.1\" byte_order=\"LittleEndian\">\n"
      "  <PUnstructuredGrid GhostLevel=\"0\">\n";
  text += fmt::format(
      "    <FieldData>\n      <DataArray type=\"Float64\" Name=\"TimeValue\" NumberOfTuples=\"1\" "
      "format=\"ascii\">{}</DataArray>\n    </FieldData>\n    <PPointData>\n",
      time);
  for (int k = 0; k < grid->GetPointData()->GetNumberOfArrays(); ++k)
    text += array_of_pieces(grid->GetPointData()->GetArray(k));
  text += "    </PPointData>\n    <PPoints>\n" + array_of_pieces(grid->GetPoints()->GetData()) + "    </PPoints>\n";
  for (const auto& piece : pieces) text += fmt::format("    <Piece Source=\"{}\"/>\n", piece);
  write_text_beside(path, text + "  </PUnstructuredGrid>\n</VTKFile>\n");
}

void write_pvd(const std::vector<TimedFile>& files, const std::string& path) {
  std::string text =
      "<?xml version=\"1.0\"?>\n<VTKFile type=\"Collection\" version=\"0.1\" byte_order=\"LittleEndian\">\n  "
      "<Collection>\n";
  for (const auto& file : files)
    text += fmt::format("    <DataSet timestep=\"{}\" part=\"0\" file=\"{}\"/>\n", file.time, file.path);
  text += "  </Collection>\n</VTKFile>\n";
  write_text_beside(path, text);
}

}  // namespace tektite
