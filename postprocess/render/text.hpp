#pragma once
// Words on a canvas, in the font of VTK, which is drawn without a window.

#include <string>

#include "postprocess/render/canvas.hpp"

namespace tektite {

enum class Across { left, centre, right };   ///< what of the words stands at the place, along the line
enum class Upwards { bottom, centre, top };  ///< and across it

struct TextStyle {
  double size = 12.0;  ///< of the font, in pixels
  Across across = Across::left;
  Upwards upwards = Upwards::bottom;
  bool turned = false;      ///< read from below to above
  double background = 0.0;  ///< opacity of white paper behind the words
};

void write(Canvas& canvas, const std::string& words, const Pixel& at, const TextStyle& style);

/// In pixels.
double width_of(const std::string& words, double size);

}  // namespace tektite
