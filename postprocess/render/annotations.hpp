#pragma once
// What is written on a picture: title, colour bar, scale bar, legend and the lines of the measures.

#include <string>
#include <vector>

#include "postprocess/measure/measure.hpp"
#include "postprocess/render/categories.hpp"

class vtkRenderer;
class vtkScalarsToColors;

namespace tektite {

/// `overlay` covers the window; `scene` is the renderer of the particles, its camera aimed.
void add_title(vtkRenderer* overlay, const std::string& title, const std::string& subtitle);
void add_colour_bar(vtkRenderer* overlay, vtkScalarsToColors* colours, const std::string& title);
/// A coloured square and a name for each category.
void add_legend(vtkRenderer* overlay, const std::vector<Category>& categories);
/// A bar of a round length, below the particles.
void add_scale_bar(vtkRenderer* overlay, vtkRenderer* scene);

struct DimensionLine {
  Segment segment;
  std::string label;
};
/// Lines with end ticks and labels; those that run along each other are set apart sideways.
void add_dimension_lines(vtkRenderer* scene, const std::vector<DimensionLine>& lines);

}  // namespace tektite
