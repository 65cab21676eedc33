#pragma once

#include <vtkImageData.h>
#include <vtkPNGReader.h>
#include <vtkSmartPointer.h>

#include <array>
#include <map>
#include <string>

namespace tektite::test {

using Colour = std::array<int, 3>;

/// Number of pixels of each colour.
inline std::map<Colour, int> colours_of(const std::string& path) {
  const auto reader = vtkSmartPointer<vtkPNGReader>::New();
  reader->SetFileName(path.c_str());
  reader->Update();
  auto* image = reader->GetOutput();
  const auto* size = image->GetDimensions();
  std::map<Colour, int> count;
  for (int y = 0; y < size[1]; ++y)
    for (int x = 0; x < size[0]; ++x) {
      Colour colour;
      for (int k = 0; k < 3; ++k)
        colour[static_cast<std::size_t>(k)] = static_cast<int>(image->GetScalarComponentAsDouble(x, y, 0, k));
      ++count[colour];
    }
  return count;
}

}  // namespace tektite::test
