#pragma once
// White paper that particles, lines and text are painted on with smooth edges. It needs no window and no X server.

#include <cstdint>
#include <utility>
#include <vector>

#include "postprocess/render/colours.hpp"

namespace tektite {

/// A place on a canvas: in pixels from its lower left corner, the middle of the first pixel is at one half.
struct Pixel {
  double x = 0.0;
  double y = 0.0;
};

/// Whole pixels; `right` and `upper` are the first ones outside.
struct Frame {
  int left = 0, lower = 0, right = 0, upper = 0;
  int width() const { return right - left; }
  int height() const { return upper - lower; }
};

class Canvas {
 public:
  Canvas(int width, int height);

  int width() const { return all_.right; }
  int height() const { return all_.upper; }
  Frame all() const { return all_; }

  /// From now on only this part is painted on.
  void clip(const Frame& part);

  void rectangle(const Pixel& lower_left, const Pixel& upper_right, const Colour& colour);
  void disc(const Pixel& centre, double radius, const Colour& colour);
  /// Lines with round ends, painted as one stroke: where they meet or cross nothing is painted twice.
  void lines(const std::vector<std::pair<Pixel, Pixel>>& segments, double width, const Colour& colour);
  /// Lays a colour over one pixel; nothing outside of the part that is painted on. Opacity between 0 and 1.
  void blend(int x, int y, const Colour& colour, double opacity);

  /// Three bytes a pixel from a row's left end on: red, green, blue.
  std::uint8_t* row(int y) { return bytes_.data() + place(0, y) * 3; }
  const std::uint8_t* row(int y) const { return bytes_.data() + place(0, y) * 3; }

 private:
  /// The pixels that a box reaches, within the part that is painted on.
  Frame within(double left, double lower, double right, double upper) const;

  std::size_t place(int x, int y) const {
    return static_cast<std::size_t>(y) * static_cast<std::size_t>(all_.right) + static_cast<std::size_t>(x);
  }

  Frame all_, part_;
  std::vector<std::uint8_t> bytes_;
  std::vector<float> coverage_;  ///< of a stroke, a number a pixel; zero between two strokes
};

}  // namespace tektite
