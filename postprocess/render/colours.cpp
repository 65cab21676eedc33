#include "postprocess/render/colours.hpp"

#include <vtkColorTransferFunction.h>
#include <vtkLookupTable.h>

namespace tektite {
namespace {

constexpr std::array<std::array<int, 3>, 9> viridis{{{68, 1, 84},
                                                     {71, 44, 122},
                                                     {59, 81, 139},
                                                     {44, 113, 142},
                                                     {33, 144, 141},
                                                     {39, 173, 129},
                                                     {92, 200, 99},
                                                     {170, 220, 50},
                                                     {253, 231, 37}}};

constexpr std::array<Colour, 7> okabe_ito{{{0.90, 0.62, 0.00},
                                           {0.00, 0.45, 0.70},
                                           {0.00, 0.62, 0.45},
                                           {0.80, 0.40, 0.00},
                                           {0.80, 0.60, 0.70},
                                           {0.35, 0.70, 0.90},
                                           {0.95, 0.90, 0.25}}};

}  // namespace

vtkSmartPointer<vtkScalarsToColors> continuous_colours(double least, double most) {
  auto colours = vtkSmartPointer<vtkColorTransferFunction>::New();
  colours->SetColorSpaceToLab();
  for (std::size_t k = 0; k < viridis.size(); ++k) {
    const double share = static_cast<double>(k) / static_cast<double>(viridis.size() - 1);
    const auto& [red, green, blue] = viridis[k];
    colours->AddRGBPoint(least + share * (most - least), red / 255.0, green / 255.0, blue / 255.0);
  }
  return colours;
}

vtkSmartPointer<vtkScalarsToColors> listed_colours(const std::vector<Colour>& list) {
  auto colours = vtkSmartPointer<vtkLookupTable>::New();
  colours->SetNumberOfTableValues(static_cast<vtkIdType>(list.size()));
  colours->SetTableRange(-0.5, static_cast<double>(list.size()) - 0.5);
  for (std::size_t k = 0; k < list.size(); ++k) {
    const auto& [red, green, blue] = list[k];
    colours->SetTableValue(static_cast<vtkIdType>(k), red, green, blue);
  }
  return colours;
}

const Colour& distinct_colour(std::size_t k) { return okabe_ito[k % okabe_ito.size()]; }

}  // namespace tektite
