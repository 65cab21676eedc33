#pragma once

#include <vtkImageData.h>
#include <vtkPNGReader.h>
#include <vtkSmartPointer.h>

#include <algorithm>
#include <array>
#include <limits>
#include <map>
#include <string>

namespace tektite::test {

using Colour = std::array<int, 3>;

/// Of a picture, in pixels from its lower left corner; `right` and `upper` are the first ones outside.
struct Part {
  int left = 0, lower = 0, right = std::numeric_limits<int>::max(), upper = std::numeric_limits<int>::max();
};

/// Number of pixels of each colour.
inline std::map<Colour, int> colours_of(const std::string& path, const Part& part = {}) {
  const auto reader = vtkSmartPointer<vtkPNGReader>::New();
  reader->SetFileName(path.c_str());
  reader->Update();
  auto* image = reader->GetOutput();
  const auto* size = image->GetDimensions();
  std::map<Colour, int> count;
  for (int y = part.lower; y < std::min(size[1], part.upper); ++y)
    for (int x = part.left; x < std::min(size[0], part.right); ++x) {
      Colour colour;
      for (int k = 0; k < 3; ++k)
        colour[static_cast<std::size_t>(k)] = static_cast<int>(image->GetScalarComponentAsDouble(x, y, 0, k));
      ++count[colour];
    }
  return count;
}

}  // namespace tektite::test
