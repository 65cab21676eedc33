#include "postprocess/render/particle_picture.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <optional>

#include "core/error.hpp"
#include "postprocess/render/annotations.hpp"
#include "postprocess/render/canvas.hpp"
#include "postprocess/render/categories.hpp"
#include "postprocess/render/framing.hpp"
#include "postprocess/render/paint_particles.hpp"
#include "postprocess/render/words.hpp"
#include "postprocess/scalar_field.hpp"
#include "postprocess/shown_unit.hpp"

namespace tektite {
namespace {

std::vector<bool> particles_to_draw(const Picture& picture, const Whole& whole,
                                    const std::optional<SymmetryPlane>& cut) {
  std::vector<bool> drawn(whole.count());
  for (std::size_t i = 0; i < drawn.size(); ++i) {
    const auto& body = whole.bodies[static_cast<std::size_t>(whole.body[i])].name;
    const bool wanted =
        picture.bodies.empty() || std::find(picture.bodies.begin(), picture.bodies.end(), body) != picture.bodies.end();
    drawn[i] = wanted && !(cut && (whole.position[i][cut->axis] - cut->at) * cut->side < 0.0);
  }
  if (std::find(drawn.begin(), drawn.end(), true) == drawn.end()) throw RunError("there is no particle to draw");
  return drawn;
}

/// The range of the drawn values without the outermost half per cent on either side, which a few stray particles
/// would otherwise decide. Never empty.
std::pair<double, double> colour_range(const std::vector<double>& values, const std::vector<bool>& drawn) {
  std::vector<double> sorted;
  for (std::size_t i = 0; i < values.size(); ++i)
    if (drawn[i]) sorted.push_back(values[i]);
  std::sort(sorted.begin(), sorted.end());
  const auto skip = sorted.size() / 200;
  const double least = sorted[skip];
  const double most = sorted[sorted.size() - 1 - skip];
  if (most > least) return {least, most};
  const double half = least == 0.0 ? 1.0 : 0.5 * std::abs(least);
  return {least - half, least + half};
}

/// Damage is between 0 and 1 by its meaning; so are its colours, that pictures of several times can be compared.
std::pair<double, double> usual_range(const std::string& field, const std::vector<double>& values,
                                      const std::vector<bool>& drawn) {
  return field == info(Field::damage).name ? std::pair{0.0, 1.0} : colour_range(values, drawn);
}

std::vector<Colour> colours_of(const std::vector<double>& values, const std::pair<double, double>& range) {
  std::vector<Colour> colours;
  for (const double value : values)
    colours.push_back(continuous_colour((value - range.first) / (range.second - range.first)));
  return colours;
}

std::vector<Colour> colours_of(const std::vector<double>& values, const std::vector<Category>& categories) {
  std::vector<Colour> colours;
  for (const double value : values) colours.push_back(categories[static_cast<std::size_t>(value)].colour);
  return colours;
}

/// The measures that have a line to draw and were taken at this time.
std::vector<DimensionLine> dimension_lines(const Picture& picture, const Drawing& drawing, double time) {
  std::vector<DimensionLine> lines;
  if (!picture.measures) return lines;
  for (const auto& [name, si_unit, measured] : drawing.measurements) {
    if (!measured.drawing || measured.time != time) continue;
    const auto unit = shown_unit(measured.value, si_unit);
    lines.push_back(
        {*measured.drawing, fmt::format("{} {:.3g} ± {:.1g} {}", readable(name), measured.value * unit.factor,
                                        measured.uncertainty * unit.factor, unit.label)});
  }
  return lines;
}

/// The part of the canvas that the particles are painted on; the rest is for words.
Frame scene_frame(const Canvas& canvas) {
  const auto part = [](double share, int size) { return static_cast<int>(std::lround(share * size)); };
  return {part(0.02, canvas.width()), part(0.08, canvas.height()), part(0.85, canvas.width()),
          part(0.89, canvas.height())};
}

}  // namespace

void draw_particles(const Picture& picture, const Snapshot& snapshot, const Drawing& drawing, const std::string& path) {
  const auto field = scalar_field(snapshot, picture.field);
  if (!field) throw RunError(fmt::format("the snapshot at {} s has no {}", snapshot.time(), picture.field));
  const auto whole = make_whole(snapshot, drawing.scene.symmetry);
  const auto cut = cut_of(picture, drawing.scene);
  const auto drawn = particles_to_draw(picture, whole, cut);
  const auto values = with_images(*field, picture.field, whole, drawing.scene.symmetry);
  const auto range = picture.range.value_or(usual_range(picture.field, values, drawn));
  const auto categories = categories_of(picture.field, whole);

  Canvas canvas(picture.width, picture.height);
  const auto frame = scene_frame(canvas);
  const auto lines = dimension_lines(picture, drawing, snapshot.time());
  std::vector<Segment> segments;
  for (const auto& line : lines) segments.push_back(line.segment);
  const auto camera = aimed_camera(frame, framed(picture, whole, drawn, segments), whole.dimensions, picture, cut);

  paint_particles(canvas, frame, camera, whole, drawn,
                  categories ? colours_of(values, *categories) : colours_of(values, range));
  canvas.clip(frame);
  add_dimension_lines(canvas, camera, frame, lines);
  canvas.clip(canvas.all());
  add_title(canvas, drawing.scene.title,
            fmt::format("{}, {}", readable(picture.field), time_in_words(snapshot.time(), drawing.event.contact_time)));
  add_scale_bar(canvas, camera, frame);
  if (categories)
    add_legend(canvas, *categories);
  else
    add_colour_bar(canvas, range, readable(picture.field), scalar_field_unit(picture.field));
  canvas.write_png(path);
}

}  // namespace tektite
