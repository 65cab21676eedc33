#include "postprocess/render/paint_particles.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numbers>
#include <optional>

namespace tektite {
namespace {

/// Places within a pixel at which it is looked at, so that edges are smooth: no two in one row or column.
constexpr std::array<Pixel, 4> samples{{{0.375, 0.125}, {0.875, 0.375}, {0.125, 0.625}, {0.625, 0.875}}};
constexpr int rows_at_once = 32;  // whose samples fit into a processor's own cache

/// What is seen of a particle at a place: how near it is to the camera, and its brightness.
struct Seen {
  double nearness, brightness;
};

struct Spot {
  Pixel at;
  double nearness;
  double spacing;  ///< in pixels
  std::array<float, 3> colour;
};

/// Of several cells that reach a place the one with the nearest middle is seen.
struct Cell {
  static double radius(double spacing) { return spacing / std::numbers::sqrt2; }
  static std::optional<Seen> seen(const Spot& spot, double squared_distance) {
    if (squared_distance > 0.5 * spot.spacing * spot.spacing) return std::nullopt;
    // Where spacings differ the border of two cells lies as far inside both.
    return Seen{0.5 * spot.spacing - std::sqrt(2.0 * squared_distance), 1.0};
  }
};

struct Sphere {
  static double radius(double spacing) { return 0.5 * spacing; }
  static std::optional<Seen> seen(const Spot& spot, double squared_distance) {
    const double squared_radius = 0.25 * spot.spacing * spot.spacing;
    if (squared_distance > squared_radius) return std::nullopt;
    const double height = std::sqrt(squared_radius - squared_distance);
    return Seen{spot.nearness + height, 2.0 * height / spot.spacing};
  }
};

/// Some rows of the frame, sample by sample.
class Rows {
 public:
  Rows(const Frame& frame, int lower)
      : frame_{frame.left, lower, frame.right, std::min(lower + rows_at_once, frame.upper)},
        nearness_(samples.size() * static_cast<std::size_t>(frame_.width()) * static_cast<std::size_t>(frame_.height()),
                  -std::numeric_limits<float>::infinity()),
        colour_(nearness_.size()) {}

  template <class Shape>
  void paint(const Spot& spot) {
    const double radius = Shape::radius(spot.spacing);
    const auto from = [](double at, int least, int most) {
      return static_cast<int>(std::clamp(std::floor(at), static_cast<double>(least), static_cast<double>(most)));
    };
    const int left = from(spot.at.x - radius, frame_.left, frame_.right);
    const int right = from(spot.at.x + radius + 1.0, frame_.left, frame_.right);
    const int lower = from(spot.at.y - radius, frame_.lower, frame_.upper);
    const int upper = from(spot.at.y + radius + 1.0, frame_.lower, frame_.upper);
    for (int y = lower; y < upper; ++y)
      for (int x = left; x < right; ++x) paint_pixel<Shape>(spot, x, y);
  }

  /// The mean of each pixel's samples; where there is none the paper is left.
  void lay_on(Canvas& canvas) const {
    Image image(frame_.width(), frame_.height());
    std::size_t at = 0;
    for (int y = 0; y < image.height(); ++y)
      for (int x = 0; x < image.width(); ++x, at += samples.size()) image.set(x, y, mean(at));
    canvas.lay(image, frame_.left, frame_.lower);
  }

 private:
  template <class Shape>
  void paint_pixel(const Spot& spot, int x, int y) {
    auto at = samples.size() * (static_cast<std::size_t>(y - frame_.lower) * static_cast<std::size_t>(frame_.width()) +
                                static_cast<std::size_t>(x - frame_.left));
    for (const auto& sample : samples) {
      const double apart_x = x + sample.x - spot.at.x, apart_y = y + sample.y - spot.at.y;
      const auto seen = Shape::seen(spot, apart_x * apart_x + apart_y * apart_y);
      if (seen && static_cast<float>(seen->nearness) > nearness_[at]) {
        nearness_[at] = static_cast<float>(seen->nearness);
        for (std::size_t k = 0; k < 3; ++k)
          colour_[at][k] = static_cast<std::uint8_t>(seen->brightness * spot.colour[k] + 0.5);
      }
      ++at;
    }
  }

  std::array<std::uint8_t, 4> mean(std::size_t at) const {
    constexpr unsigned all = samples.size();
    std::array<unsigned, 4> sum{};
    for (std::size_t k = at; k < at + all; ++k) {
      for (std::size_t c = 0; c < 3; ++c) sum[c] += colour_[k][c];
      if (nearness_[k] > -std::numeric_limits<float>::infinity()) sum[3] += 255;
    }
    std::array<std::uint8_t, 4> pixel{};
    for (std::size_t c = 0; c < pixel.size(); ++c) pixel[c] = static_cast<std::uint8_t>((sum[c] + all / 2) / all);
    return pixel;
  }

  Frame frame_;
  std::vector<float> nearness_;
  std::vector<std::array<std::uint8_t, 3>> colour_;
};

template <class Shape>
void paint(Canvas& canvas, const Frame& frame, const std::vector<Spot>& spots) {
  // The spots that reach into each lot of rows.
  const auto lots = static_cast<std::size_t>((frame.height() + rows_at_once - 1) / rows_at_once);
  std::vector<std::vector<std::size_t>> reaching(lots);
  for (std::size_t k = 0; k < spots.size(); ++k) {
    const auto& spot = spots[k];
    const double radius = Shape::radius(spot.spacing);
    const auto lot = [&](double y) { return std::floor((y - frame.lower) / rows_at_once); };
    const double first = std::max(lot(spot.at.y - radius), 0.0);
    const double last = std::min(lot(spot.at.y + radius), static_cast<double>(lots) - 1.0);
    for (double each = first; each <= last; ++each) reaching[static_cast<std::size_t>(each)].push_back(k);
  }
  for (std::size_t lot = 0; lot < lots; ++lot) {
    if (reaching[lot].empty()) continue;
    Rows rows(frame, frame.lower + static_cast<int>(lot) * rows_at_once);
    for (const auto k : reaching[lot]) rows.template paint<Shape>(spots[k]);
    rows.lay_on(canvas);
  }
}

}  // namespace

void paint_particles(Canvas& canvas, const Frame& frame, const Camera& camera, const Whole& whole,
                     const std::vector<bool>& drawn, const std::vector<Colour>& colours) {
  std::vector<Spot> spots;
  for (std::size_t i = 0; i < whole.count(); ++i) {
    if (!drawn[i]) continue;
    Spot spot{camera(whole.position[i]),
              camera.nearness(whole.position[i]),
              camera.scale * whole.bodies[static_cast<std::size_t>(whole.body[i])].spacing,
              {}};
    for (std::size_t k = 0; k < 3; ++k) spot.colour[k] = static_cast<float>(255.0 * colours[i][k]);
    spots.push_back(spot);
  }
  if (whole.dimensions < 3)
    paint<Cell>(canvas, frame, spots);
  else
    paint<Sphere>(canvas, frame, spots);
}

}  // namespace tektite
