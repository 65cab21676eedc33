#include "postprocess/render/annotations.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "postprocess/render/axis.hpp"
#include "postprocess/render/places_apart.hpp"
#include "postprocess/render/text.hpp"
#include "postprocess/shown_unit.hpp"

namespace tektite {
namespace {

constexpr Colour black{0.0, 0.0, 0.0};
constexpr Colour white{1.0, 1.0, 1.0};

// Lengths on a picture are relative to the height of what they stand on, so that a larger picture shows the same.
constexpr double words_size = 0.026;

/// The largest of 1, 2, 5 times a power of ten that is not above `most`.
double round_length(double most) {
  const double power = std::pow(10.0, std::floor(std::log10(most)));
  for (const double step : {5.0, 2.0})
    if (step * power <= most) return step * power;
  return power;
}

/// The words of a line, as high as a line of text.
struct Label {
  std::string words;
  PictureBox box;
};

/// To the left of an upright line's upper quarter, where the lines across it leave room; else at the right end.
Label label_of(const std::string& words, double height, const Pixel& from, const Pixel& to) {
  const bool upright = std::abs(to.y - from.y) > std::abs(to.x - from.x);
  const double gap = 0.01 * height, length = width_of(words, words_size * height);
  const auto& right_end = to.x > from.x ? to : from;
  const double left = upright ? 0.5 * (from.x + to.x) - gap - length : right_end.x + gap;
  const double middle = upright ? std::min(from.y, to.y) + 0.75 * std::abs(to.y - from.y) : right_end.y;
  const double half = 0.7 * words_size * height;
  return {words, {left, middle - half, left + length, middle + half}};
}

/// One line with ticks across its ends, `shift` aside; black on a white rim, to be seen on every colour. Its label.
Label add_dimension_line(Canvas& canvas, double height, Pixel from, Pixel to, double shift, const std::string& words) {
  const double length = std::max(1e-9, std::hypot(to.x - from.x, to.y - from.y));
  Pixel across{-(to.y - from.y) / length, (to.x - from.x) / length};
  if (across.y > 0.0 || (across.y == 0.0 && across.x < 0.0)) across = {-across.x, -across.y};
  for (auto* end : {&from, &to}) {
    end->x += shift * across.x;
    end->y += shift * across.y;
  }
  const double tick = 0.012 * height;
  const auto tick_at = [&](const Pixel& end) {
    return std::pair{Pixel{end.x - tick * across.x, end.y - tick * across.y},
                     Pixel{end.x + tick * across.x, end.y + tick * across.y}};
  };
  const std::vector<std::pair<Pixel, Pixel>> lines{{from, to}, tick_at(from), tick_at(to)};
  canvas.lines(lines, 4.5, white);
  canvas.lines(lines, 2.0, black);
  return label_of(words, height, from, to);
}

void write_apart(Canvas& canvas, const std::vector<Label>& labels, double height) {
  std::vector<PictureBox> boxes;
  for (const auto& label : labels) boxes.push_back(label.box);
  boxes = places_apart(std::move(boxes));
  for (std::size_t k = 0; k < labels.size(); ++k)
    write(canvas, labels[k].words, {boxes[k].left, 0.5 * (boxes[k].lower + boxes[k].upper)},
          {.size = words_size * height, .upwards = Upwards::centre, .background = 0.8});
}

}  // namespace

void add_title(Canvas& canvas, const std::string& title, const std::string& subtitle) {
  const double left = 0.03 * canvas.width(), height = canvas.height();
  write(canvas, title, {left, 0.945 * height}, {.size = 0.032 * height});
  write(canvas, subtitle, {left, 0.905 * height}, {.size = words_size * height});
}

void add_colour_bar(Canvas& canvas, const std::pair<double, double>& range, const std::string& name,
                    const std::string& si_unit) {
  const double width = canvas.width(), height = canvas.height();
  const double left = std::round(0.88 * width), right = std::round(0.908 * width);
  const int lower = static_cast<int>(std::lround(0.125 * height)), upper = static_cast<int>(std::lround(0.82 * height));
  for (int y = lower; y < upper; ++y)
    canvas.rectangle({left, y + 0.0}, {right, y + 1.0}, continuous_colour((y + 0.5 - lower) / (upper - lower)));
  const auto unit = shown_unit(std::max(std::abs(range.first), std::abs(range.second)), si_unit);
  constexpr int labels = 6;
  const double step = unit.factor * (range.second - range.first) / (labels - 1);
  for (int k = 0; k < labels; ++k) {
    const double share = static_cast<double>(k) / (labels - 1);
    const double value = unit.factor * range.first + k * step;
    write(canvas, fmt::format("{:.3g}", without_round_off(value, step)),
          {right + 0.005 * width, lower + share * (upper - lower)},
          {.size = 0.024 * height, .upwards = Upwards::centre});
  }
  write(canvas, name + (unit.label.empty() ? "" : ", " + unit.label), {0.98 * width, 0.84 * height},
        {.size = words_size * height, .across = Across::right});
}

void add_legend(Canvas& canvas, const std::vector<Category>& categories) {
  const double width = canvas.width(), height = canvas.height();
  const double line = 0.045 * height;
  double longest = 0.0;
  for (const auto& category : categories) longest = std::max(longest, width_of(category.name, words_size * height));
  // A long name moves the legend to the left.
  const double left = std::min(0.87 * width, 0.985 * width - 0.7 * line - longest);
  const double top = 0.8 * height, bottom = 0.1 * height;
  const auto room = static_cast<std::size_t>((top - bottom) / line);
  const std::size_t named = categories.size() > room ? room - 1 : categories.size();
  const auto write_at = [&](const std::string& words, double y) {
    write(canvas, words, {left + 0.7 * line, y}, {.size = words_size * height, .upwards = Upwards::centre});
  };
  for (std::size_t k = 0; k < named; ++k) {
    const double y = top - line * static_cast<double>(k);
    canvas.rectangle({left, y - 0.25 * line}, {left + 0.5 * line, y + 0.25 * line}, categories[k].colour);
    write_at(categories[k].name, y);
  }
  if (named < categories.size())
    write_at(fmt::format("and {} more", categories.size() - named), top - line * static_cast<double>(named));
}

void add_scale_bar(Canvas& canvas, const Camera& camera, const Frame& scene) {
  const double length = round_length(0.2 * scene.width() / camera.scale);
  const double height = canvas.height();
  const Pixel from{0.03 * canvas.width(), 0.045 * height};
  const Pixel to{from.x + length * camera.scale, from.y};
  const double tick = 0.01 * height;
  canvas.lines(
      {{from, to}, {{from.x, from.y - tick}, {from.x, from.y + tick}}, {{to.x, to.y - tick}, {to.x, to.y + tick}}}, 3.0,
      black);
  const auto unit = shown_unit(length, "m");
  write(canvas, fmt::format("{:.3g} {}", length * unit.factor, unit.label), {to.x + 2.0 * tick, to.y},
        {.size = words_size * height, .upwards = Upwards::centre});
}

void add_dimension_lines(Canvas& canvas, const Camera& camera, const Frame& scene,
                         const std::vector<DimensionLine>& lines) {
  const double height = scene.height();
  std::vector<Segment> placed;
  std::vector<Label> labels;
  for (const auto& line : lines) {
    const auto direction = line.segment.to - line.segment.from;
    const auto parallel = [&](const Segment& other) {
      const auto along = other.to - other.from;
      return std::abs(dot(along, direction)) > 0.99 * norm(along) * norm(direction);
    };
    const auto before = std::count_if(placed.begin(), placed.end(), parallel);
    placed.push_back(line.segment);
    labels.push_back(add_dimension_line(canvas, height, camera(line.segment.from), camera(line.segment.to),
                                        0.05 * height * static_cast<double>(before), line.label));
  }
  write_apart(canvas, labels, height);
}

}  // namespace tektite
