#include "postprocess/render/image.hpp"

#include <fmt/format.h>
#include <vtkPNGWriter.h>
#include <vtkRenderWindow.h>
#include <vtkSmartPointer.h>
#include <vtkWindowToImageFilter.h>

#include "core/error.hpp"
#include "core/write_beside.hpp"

namespace tektite {

void write_png(vtkRenderWindow* window, const std::string& path) {
  window->Render();
  const auto image = vtkSmartPointer<vtkWindowToImageFilter>::New();
  image->SetInput(window);
  image->ReadFrontBufferOff();
  write_beside(path, [&](const std::string& beside) {
    const auto writer = vtkSmartPointer<vtkPNGWriter>::New();
    writer->SetFileName(beside.c_str());
    writer->SetInputConnection(image->GetOutputPort());
    writer->Write();
    if (writer->GetErrorCode() != 0) throw RunError(fmt::format("{} cannot be written", path));
  });
}

}  // namespace tektite
