#pragma once
// What is written on a picture: title, colour bar, scale bar, legend and the lines of the measures.

#include <string>
#include <utility>
#include <vector>

#include "postprocess/measure/measure.hpp"
#include "postprocess/render/canvas.hpp"
#include "postprocess/render/categories.hpp"
#include "postprocess/render/framing.hpp"

namespace tektite {

void add_title(Canvas& canvas, const std::string& title, const std::string& subtitle);
/// The continuous colours for `range`, in SI, with numbers in the unit that suits them.
void add_colour_bar(Canvas& canvas, const std::pair<double, double>& range, const std::string& name,
                    const std::string& si_unit);
/// A coloured square and a name for each category.
void add_legend(Canvas& canvas, const std::vector<Category>& categories);
/// A bar of a round length, below the particles, which the camera shows in `scene`.
void add_scale_bar(Canvas& canvas, const Camera& camera, const Frame& scene);

struct DimensionLine {
  Segment segment;
  std::string label;
};
/// Lines with end ticks and labels; those that run along each other are set apart sideways, and no label covers
/// another.
void add_dimension_lines(Canvas& canvas, const Camera& camera, const Frame& scene,
                         const std::vector<DimensionLine>& lines);

}  // namespace tektite
