#include "postprocess/render/profile.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "core/error.hpp"
#include "postprocess/render/line_chart.hpp"
#include "postprocess/render/words.hpp"
#include "postprocess/scalar_field.hpp"
#include "postprocess/shown_unit.hpp"

namespace tektite {
namespace {

bool is_wanted(const Picture& picture, const std::string& body) {
  return picture.bodies.empty() || std::ranges::find(picture.bodies, body) != picture.bodies.end();
}

double coordinate(const Picture& picture, const Point& x) {
  return picture.along == "radius" ? norm(x - picture.centre) : x[picture.along.front() - 'x'];
}

ChartLine computed(const Picture& picture, const Snapshot& snapshot, const std::vector<double>& field) {
  const auto& particles = snapshot.particles;
  const auto dimensions = static_cast<std::size_t>(particles.dimensions());
  const auto position = particles.reals(Field::position);
  ChartLine line{"computed", {}, {}, true};
  for (const auto& body : particles.bodies()) {
    if (!is_wanted(picture, body.name)) continue;
    for (auto i = body.range.begin; i < body.range.end; ++i) {
      auto x = Point::zero();
      for (std::size_t k = 0; k < dimensions; ++k) x[static_cast<int>(k)] = position[i * dimensions + k];
      line.x.push_back(coordinate(picture, x));
      line.y.push_back(field[i]);
    }
  }
  return line;
}

/// Brings numbers into the unit that suits the largest of them; its label.
std::string show_in_unit(std::vector<ChartLine>& lines, std::vector<double> ChartLine::*numbers,
                         const std::string& si_unit) {
  double most = 0.0;
  for (const auto& line : lines)
    for (const double value : line.*numbers) most = std::max(most, std::abs(value));
  const auto unit = shown_unit(most, si_unit);
  for (auto& line : lines)
    for (double& value : line.*numbers) value *= unit.factor;
  return unit.label.empty() ? "" : ", " + unit.label;
}

}  // namespace

void draw_profile(const Picture& picture, const Snapshot& snapshot, const Drawing& drawing, const std::string& path) {
  const auto field = scalar_field(snapshot, picture.field);
  if (!field) throw RunError(fmt::format("the snapshot at {} s has no {}", snapshot.time(), picture.field));
  std::vector<ChartLine> lines{computed(picture, snapshot, *field)};
  if (!picture.exact.empty()) {
    ChartLine exact{"exact", {}, {}, false};
    for (const auto& point : picture.exact) {
      exact.x.push_back(point[0]);
      exact.y.push_back(point[1]);
    }
    lines.push_back(exact);
  }
  const auto along_unit = show_in_unit(lines, &ChartLine::x, "m");
  const auto field_unit = show_in_unit(lines, &ChartLine::y, scalar_field_unit(picture.field));
  const auto name = readable(picture.field);
  draw_line_chart(
      {fmt::format("{}: {}, {}", drawing.scene.title, name, time_in_words(snapshot.time(), drawing.event.contact_time)),
       picture.along + along_unit, name + field_unit, lines, picture.width, picture.height},
      path);
}

}  // namespace tektite
