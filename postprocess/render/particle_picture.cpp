#include "postprocess/render/particle_picture.hpp"

#include <fmt/format.h>
#include <vtkActor.h>
#include <vtkRenderWindow.h>
#include <vtkRenderer.h>
#include <vtkRendererCollection.h>
#include <vtkScalarsToColors.h>
#include <vtkSmartPointer.h>

#include <algorithm>
#include <optional>

#include "core/error.hpp"
#include "postprocess/render/annotations.hpp"
#include "postprocess/render/categories.hpp"
#include "postprocess/render/colours.hpp"
#include "postprocess/render/framing.hpp"
#include "postprocess/render/image.hpp"
#include "postprocess/render/particle_actors.hpp"
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

vtkSmartPointer<vtkScalarsToColors> colours_of(const std::vector<Category>& categories) {
  std::vector<Colour> colours;
  for (const auto& category : categories) colours.push_back(category.colour);
  return listed_colours(colours);
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

/// Three layers in place of what was drawn before: white paper, the particles on a part of it, and what is written over
/// all.
void lay_out(vtkRenderWindow* window, const Picture& picture, vtkRenderer* scene, vtkRenderer* overlay) {
  while (auto* const before = window->GetRenderers()->GetFirstRenderer()) window->RemoveRenderer(before);
  window->SetSize(picture.width, picture.height);
  const auto paper = vtkSmartPointer<vtkRenderer>::New();
  paper->SetBackground(1.0, 1.0, 1.0);
  scene->SetViewport(0.02, 0.08, 0.85, 0.89);
  int layer = 0;
  for (auto* renderer : {paper.Get(), scene, overlay}) {
    renderer->SetLayer(layer++);
    window->AddRenderer(renderer);
  }
}

}  // namespace

ParticlePictures::ParticlePictures() : window_(vtkSmartPointer<vtkRenderWindow>::New()) {
  window_->SetOffScreenRendering(1);
  window_->SetMultiSamples(8);
  window_->SetNumberOfLayers(3);
}

void ParticlePictures::draw(const Picture& picture, const Snapshot& snapshot, const Drawing& drawing,
                            const std::string& path) {
  const auto field = scalar_field(snapshot, picture.field);
  if (!field) throw RunError(fmt::format("the snapshot at {} s has no {}", snapshot.time(), picture.field));
  const auto whole = make_whole(snapshot, drawing.scene.symmetry);
  const auto cut = cut_of(picture, drawing.scene);
  const auto drawn = particles_to_draw(picture, whole, cut);

  auto values = with_images(*field, picture.field, whole, drawing.scene.symmetry);
  const auto range = picture.range.value_or(usual_range(picture.field, values, drawn));
  const auto unit =
      shown_unit(std::max(std::abs(range.first), std::abs(range.second)), scalar_field_unit(picture.field));
  for (auto& value : values) value *= unit.factor;
  const auto categories = categories_of(picture.field, whole);
  const auto colours =
      categories ? colours_of(*categories) : continuous_colours(range.first * unit.factor, range.second * unit.factor);

  const auto scene = vtkSmartPointer<vtkRenderer>::New();
  const auto overlay = vtkSmartPointer<vtkRenderer>::New();
  lay_out(window_, picture, scene, overlay);
  scene->AddActor(particle_actor(whole, drawn, values, colours));
  const auto lines = dimension_lines(picture, drawing, snapshot.time());
  std::vector<Segment> segments;
  for (const auto& line : lines) segments.push_back(line.segment);
  aim_camera(scene, framed(picture, whole, drawn, segments), whole.dimensions, picture, cut);

  add_dimension_lines(scene, lines);
  add_title(overlay, drawing.scene.title,
            fmt::format("{}, {}", readable(picture.field), time_in_words(snapshot.time(), drawing.event.contact_time)));
  add_scale_bar(overlay, scene);
  if (categories) {
    add_legend(overlay, *categories);
  } else {
    add_colour_bar(overlay, colours, readable(picture.field) + (unit.label.empty() ? "" : ", " + unit.label));
  }
  write_png(window_, path);
}

}  // namespace tektite
