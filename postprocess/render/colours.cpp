#include "postprocess/render/colours.hpp"

#include <vtkColorTransferFunction.h>
#include <vtkSmartPointer.h>

#include <algorithm>

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

/// More colours than eyes or the bytes of a picture tell apart.
constexpr int steps = 1024;

std::array<Colour, steps> interpolated() {
  const auto function = vtkSmartPointer<vtkColorTransferFunction>::New();
  function->SetColorSpaceToLab();
  for (std::size_t k = 0; k < viridis.size(); ++k) {
    const auto& [red, green, blue] = viridis[k];
    function->AddRGBPoint(static_cast<double>(k) / static_cast<double>(viridis.size() - 1), red / 255.0, green / 255.0,
                          blue / 255.0);
  }
  std::array<Colour, steps> table;
  function->GetTable(0.0, 1.0, steps, table.front().data());
  return table;
}

}  // namespace

const Colour& continuous_colour(double share) {
  static const auto table = interpolated();
  const double within = share > 0.0 ? std::min(share, 1.0) : 0.0;
  return table[static_cast<std::size_t>(within * (steps - 1) + 0.5)];
}

const Colour& distinct_colour(std::size_t k) { return okabe_ito[k % okabe_ito.size()]; }

}  // namespace tektite
