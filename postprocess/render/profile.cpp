#include "postprocess/render/profile.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "core/error.hpp"
#include "postprocess/render/line_chart.hpp"
#include "postprocess/render/words.hpp"
#include "postprocess/scalar_field.hpp"

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

}  // namespace

void draw_profile(const Picture& picture, const Snapshot& snapshot, const Drawing& drawing, const std::string& path) {
  const auto field = scalar_field(snapshot, picture.field);
  if (!field) throw RunError(fmt::format("the snapshot at {} s has no {}", snapshot.time(), picture.field));
  std::vector<ChartLine> lines{computed(picture, snapshot, *field)};
  if (!picture.exact.empty()) lines.push_back(exact_line(picture.exact));
  const auto along_unit = show_in_unit(lines, &ChartLine::x, "m");
  const auto field_unit = show_in_unit(lines, &ChartLine::y, scalar_field_unit(picture.field));
  const auto name = readable(picture.field);
  draw_line_chart(
      {fmt::format("{}: {}, {}", drawing.scene.title, name, time_in_words(snapshot.time(), drawing.event.contact_time)),
       picture.along + ", " + along_unit, field_unit.empty() ? name : name + ", " + field_unit, lines, picture.width,
       picture.height},
      path);
}

}  // namespace tektite
