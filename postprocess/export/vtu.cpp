#include "postprocess/export/vtu.hpp"

#include <fmt/format.h>
#include <vtkCallbackCommand.h>
#include <vtkErrorCode.h>
#include <vtkExecutive.h>
#include <vtkUnstructuredGrid.h>
#include <vtkXMLUnstructuredGridWriter.h>

#include "core/error.hpp"
#include "core/write_beside.hpp"
#include "postprocess/export/grid.hpp"

namespace tektite {

void write_vtu(const Snapshot& snapshot, const std::string& path) {
  const auto grid = make_grid(snapshot);
  write_beside(path, [&](const std::string& beside) {
    const auto writer = vtkSmartPointer<vtkXMLUnstructuredGridWriter>::New();
    writer->SetFileName(beside.c_str());
    writer->SetInputData(grid);
    writer->SetDataModeToAppended();
    writer->EncodeAppendedDataOff();
    writer->SetCompressorTypeToZLib();
    const auto silence = vtkSmartPointer<vtkCallbackCommand>::New();  // what goes wrong is told by us
    writer->GetExecutive()->AddObserver(vtkCommand::ErrorEvent, silence);
    if (writer->Write() != 1 || writer->GetErrorCode() != 0)
      throw RunError(
          fmt::format("{}: cannot be written: {}", path, vtkErrorCode::GetStringFromErrorCode(writer->GetErrorCode())));
  });
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
