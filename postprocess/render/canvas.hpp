#pragma once
// White paper that particles, lines and text are painted on with smooth edges, by Cairo: no window and no X server.

#include <cairo.h>

#include <array>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <string>
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

/// Colours and opacities of some pixels, from the highest row down: nothing to begin with.
class Image {
 public:
  Image(int width, int height)
      : width_(width), height_(height), pixels_(static_cast<std::size_t>(width) * static_cast<std::size_t>(height)) {}
  int width() const { return width_; }
  int height() const { return height_; }
  /// Counted from the lower left corner; red, green and blue, each times the opacity, and this, up to 255.
  void set(int x, int y, const std::array<std::uint8_t, 4>& pixel) {
    const auto [red, green, blue, opacity] = pixel;
    pixels_[static_cast<std::size_t>(height_ - 1 - y) * static_cast<std::size_t>(width_) +
            static_cast<std::size_t>(x)] =
        std::uint32_t{opacity} << 24 | std::uint32_t{red} << 16 | std::uint32_t{green} << 8 | std::uint32_t{blue};
  }
  std::uint32_t* pixels() { return pixels_.data(); }

 private:
  int width_, height_;
  std::vector<std::uint32_t> pixels_;
};

class Canvas {
 public:
  Canvas(int width, int height);

  int width() const { return width_; }
  int height() const { return height_; }
  Frame all() const { return {0, 0, width_, height_}; }

  /// From now on only this part is painted on.
  void clip(const Frame& part);

  void rectangle(const Pixel& lower_left, const Pixel& upper_right, const Colour& colour);
  void disc(const Pixel& centre, double radius, const Colour& colour);
  /// Lines with round ends, painted as one stroke: where they meet or cross nothing is painted twice.
  void lines(const std::vector<std::pair<Pixel, Pixel>>& segments, double width, const Colour& colour);
  /// With its lower left corner here.
  void lay(Image& image, int left, int lower);

  /// Red, green and blue of a pixel, up to 255.
  std::array<std::uint8_t, 3> colour_of(int x, int y) const;

  /// Writes it beside its place and renames it. Throws RunError.
  void write_png(const std::string& path) const;

 private:
  int width_, height_;
  std::unique_ptr<cairo_surface_t, decltype(&cairo_surface_destroy)> surface_;
  std::unique_ptr<cairo_t, decltype(&cairo_destroy)> cairo_;
};

}  // namespace tektite
