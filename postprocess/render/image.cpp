#include "postprocess/render/image.hpp"

#include <fmt/format.h>
#include <vtkContextView.h>
#include <vtkErrorCode.h>
#include <vtkPNGWriter.h>
#include <vtkRenderWindow.h>
#include <vtkSmartPointer.h>
#include <vtkWindowToImageFilter.h>

#include "core/error.hpp"
#include "core/write_beside.hpp"

namespace tektite {

void write_png(vtkRenderWindow* window, const std::string& path) {
  const auto image = vtkSmartPointer<vtkWindowToImageFilter>::New();
  image->SetInput(window);
  image->ReadFrontBufferOff();  // it renders by itself
  write_beside(path, [&](const std::string& beside) {
    const auto writer = vtkSmartPointer<vtkPNGWriter>::New();
    writer->SetFileName(beside.c_str());
    writer->SetInputConnection(image->GetOutputPort());
    writer->Write();
    if (writer->GetErrorCode() != 0)
      throw RunError(
          fmt::format("{}: cannot be written: {}", path, vtkErrorCode::GetStringFromErrorCode(writer->GetErrorCode())));
  });
}

void write_png(vtkContextView* chart, const std::string& path) {
  chart->GetRenderWindow()->Render();
  write_png(chart->GetRenderWindow(), path);
}

}  // namespace tektite
