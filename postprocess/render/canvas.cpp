#include "postprocess/render/canvas.hpp"

#include <algorithm>
#include <cmath>

namespace tektite {
namespace {

constexpr std::uint8_t white = 255;

/// How much of a pixel is inside an edge: nothing half a pixel outside of it, all of it half a pixel inside.
double share_inside(double depth) { return std::clamp(depth + 0.5, 0.0, 1.0); }

/// How much of the pixel [k, k + 1] an interval covers.
double share_of(int k, double from, double to) {
  return std::clamp(std::min(to, k + 1.0) - std::max(from, static_cast<double>(k)), 0.0, 1.0);
}

double distance(const Pixel& at, const std::pair<Pixel, Pixel>& segment) {
  const auto& [from, to] = segment;
  const double along_x = to.x - from.x, along_y = to.y - from.y;
  const double squared = along_x * along_x + along_y * along_y;
  const double part =
      squared > 0.0 ? std::clamp(((at.x - from.x) * along_x + (at.y - from.y) * along_y) / squared, 0.0, 1.0) : 0.0;
  return std::hypot(at.x - from.x - part * along_x, at.y - from.y - part * along_y);
}

}  // namespace

Canvas::Canvas(int width, int height)
    : all_{0, 0, width, height},
      part_(all_),
      bytes_(3 * static_cast<std::size_t>(width) * static_cast<std::size_t>(height), white) {}

void Canvas::clip(const Frame& part) {
  part_ = {std::max(part.left, 0), std::max(part.lower, 0), std::min(part.right, all_.right),
           std::min(part.upper, all_.upper)};
}

Frame Canvas::within(double left, double lower, double right, double upper) const {
  const auto pixel = [](double at, int least, int most) {
    return static_cast<int>(std::clamp(at, static_cast<double>(least), static_cast<double>(most)));
  };
  return {pixel(std::floor(left), part_.left, part_.right), pixel(std::floor(lower), part_.lower, part_.upper),
          pixel(std::ceil(right), part_.left, part_.right), pixel(std::ceil(upper), part_.lower, part_.upper)};
}

void Canvas::blend(int x, int y, const Colour& colour, double opacity) {
  if (x < part_.left || x >= part_.right || y < part_.lower || y >= part_.upper) return;
  auto* const bytes = row(y) + 3 * x;
  for (std::size_t k = 0; k < 3; ++k)
    bytes[k] = static_cast<std::uint8_t>(std::lround((1.0 - opacity) * bytes[k] + opacity * 255.0 * colour[k]));
}

void Canvas::rectangle(const Pixel& lower_left, const Pixel& upper_right, const Colour& colour) {
  const auto box = within(lower_left.x, lower_left.y, upper_right.x, upper_right.y);
  for (int y = box.lower; y < box.upper; ++y)
    for (int x = box.left; x < box.right; ++x)
      blend(x, y, colour, share_of(x, lower_left.x, upper_right.x) * share_of(y, lower_left.y, upper_right.y));
}

void Canvas::disc(const Pixel& centre, double radius, const Colour& colour) {
  const double reach = radius + 0.5;
  const auto box = within(centre.x - reach, centre.y - reach, centre.x + reach, centre.y + reach);
  for (int y = box.lower; y < box.upper; ++y)
    for (int x = box.left; x < box.right; ++x)
      blend(x, y, colour, share_inside(radius - std::hypot(x + 0.5 - centre.x, y + 0.5 - centre.y)));
}

void Canvas::lines(const std::vector<std::pair<Pixel, Pixel>>& segments, double width, const Colour& colour) {
  const double reach = 0.5 * width + 0.5;
  coverage_.resize(bytes_.size() / 3);
  const auto boxes = [&](const auto& visit) {
    for (const auto& segment : segments) {
      const auto& [from, to] = segment;
      const auto box = within(std::min(from.x, to.x) - reach, std::min(from.y, to.y) - reach,
                              std::max(from.x, to.x) + reach, std::max(from.y, to.y) + reach);
      for (int y = box.lower; y < box.upper; ++y)
        for (int x = box.left; x < box.right; ++x) visit(segment, x, y, coverage_[place(x, y)]);
    }
  };
  boxes([&](const auto& segment, int x, int y, float& coverage) {
    const double covered = share_inside(0.5 * width - distance({x + 0.5, y + 0.5}, segment));
    coverage = std::max(coverage, static_cast<float>(covered));
  });
  boxes([&](const auto&, int x, int y, float& coverage) {
    if (coverage > 0.0F) blend(x, y, colour, coverage);
    coverage = 0.0F;
  });
}

}  // namespace tektite
