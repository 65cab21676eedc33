#include "postprocess/render/annotations.hpp"

#include <fmt/format.h>
#include <vtkActor2D.h>
#include <vtkCamera.h>
#include <vtkCellArray.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>
#include <vtkPolyDataMapper2D.h>
#include <vtkProperty2D.h>
#include <vtkRenderer.h>
#include <vtkScalarBarActor.h>
#include <vtkScalarsToColors.h>
#include <vtkSmartPointer.h>
#include <vtkTextActor.h>
#include <vtkTextProperty.h>

#include <algorithm>
#include <cmath>

#include "postprocess/render/colours.hpp"
#include "postprocess/shown_unit.hpp"

namespace tektite {
namespace {

struct Pixel {
  double x = 0.0;
  double y = 0.0;
};

/// Lengths on a picture are relative to its height, so that a larger picture shows the same.
double text_size(vtkRenderer* renderer, double share) { return share * renderer->GetSize()[1]; }

vtkSmartPointer<vtkTextActor> add_text(vtkRenderer* renderer, const std::string& text, const Pixel& at, double size) {
  auto actor = vtkSmartPointer<vtkTextActor>::New();
  actor->SetInput(text.c_str());
  actor->GetPositionCoordinate()->SetCoordinateSystemToViewport();
  actor->SetPosition(at.x, at.y);
  actor->GetTextProperty()->SetFontSize(static_cast<int>(size));
  actor->GetTextProperty()->SetColor(0.0, 0.0, 0.0);
  renderer->AddActor2D(actor);
  return actor;
}

void add_lines(vtkRenderer* renderer, const std::vector<std::pair<Pixel, Pixel>>& lines, double width,
               const Colour& colour) {
  const auto points = vtkSmartPointer<vtkPoints>::New();
  const auto cells = vtkSmartPointer<vtkCellArray>::New();
  for (const auto& [from, to] : lines) {
    const vtkIdType ends[] = {points->InsertNextPoint(from.x, from.y, 0.0), points->InsertNextPoint(to.x, to.y, 0.0)};
    cells->InsertNextCell(2, ends);
  }
  const auto data = vtkSmartPointer<vtkPolyData>::New();
  data->SetPoints(points);
  data->SetLines(cells);
  const auto mapper = vtkSmartPointer<vtkPolyDataMapper2D>::New();
  mapper->SetInputData(data);
  const auto actor = vtkSmartPointer<vtkActor2D>::New();
  actor->SetMapper(mapper);
  actor->GetProperty()->SetColor(colour[0], colour[1], colour[2]);
  actor->GetProperty()->SetLineWidth(static_cast<float>(width));
  renderer->AddActor2D(actor);
}

Pixel to_pixel(vtkRenderer* renderer, const Point& point) {
  double x = point[0];
  double y = point[1];
  double z = point[2];
  renderer->WorldToView(x, y, z);
  const auto* size = renderer->GetSize();
  return {0.5 * (x + 1.0) * size[0], 0.5 * (y + 1.0) * size[1]};
}

/// The largest of 1, 2, 5 times a power of ten that is not above `most`.
double round_length(double most) {
  const double power = std::pow(10.0, std::floor(std::log10(most)));
  for (const double step : {5.0, 2.0})
    if (step * power <= most) return step * power;
  return power;
}

/// One line with ticks across its ends; black on a white rim, to be seen on every colour.
void add_dimension_line(vtkRenderer* renderer, Pixel from, Pixel to, double shift, const std::string& label) {
  const double length = std::max(1e-9, std::hypot(to.x - from.x, to.y - from.y));
  Pixel across{-(to.y - from.y) / length, (to.x - from.x) / length};
  if (across.y > 0.0 || (across.y == 0.0 && across.x < 0.0)) across = {-across.x, -across.y};
  for (auto* end : {&from, &to}) {
    end->x += shift * across.x;
    end->y += shift * across.y;
  }
  const double tick = text_size(renderer, 0.012);
  const auto tick_at = [&](const Pixel& end) {
    return std::pair{Pixel{end.x - tick * across.x, end.y - tick * across.y},
                     Pixel{end.x + tick * across.x, end.y + tick * across.y}};
  };
  const std::vector<std::pair<Pixel, Pixel>> lines{{from, to}, tick_at(from), tick_at(to)};
  add_lines(renderer, lines, 4.5, {1.0, 1.0, 1.0});
  add_lines(renderer, lines, 2.0, {0.0, 0.0, 0.0});
  const bool upright = std::abs(to.y - from.y) > std::abs(to.x - from.x);
  const double gap = text_size(renderer, 0.01);
  // To the left of an upright line's upper quarter, where the lines across it leave room; else at the right end.
  const auto& right = to.x > from.x ? to : from;
  const double upper_quarter = std::min(from.y, to.y) + 0.75 * std::abs(to.y - from.y);
  const Pixel anchor = upright ? Pixel{0.5 * (from.x + to.x) - gap, upper_quarter} : Pixel{right.x + gap, right.y};
  const auto text = add_text(renderer, label, anchor, text_size(renderer, 0.026));
  if (upright) text->GetTextProperty()->SetJustificationToRight();
  text->GetTextProperty()->SetBackgroundColor(1.0, 1.0, 1.0);
  text->GetTextProperty()->SetBackgroundOpacity(0.8);
  text->GetTextProperty()->SetVerticalJustificationToCentered();
}

}  // namespace

void add_title(vtkRenderer* overlay, const std::string& title, const std::string& subtitle) {
  const auto* size = overlay->GetSize();
  add_text(overlay, title, {0.03 * size[0], 0.945 * size[1]}, text_size(overlay, 0.032));
  add_text(overlay, subtitle, {0.03 * size[0], 0.905 * size[1]}, text_size(overlay, 0.026));
}

void add_colour_bar(vtkRenderer* overlay, vtkScalarsToColors* colours, const std::string& title) {
  const auto* size = overlay->GetSize();
  const auto bar = vtkSmartPointer<vtkScalarBarActor>::New();
  bar->SetLookupTable(colours);
  bar->SetNumberOfLabels(6);
  bar->SetLabelFormat("%.3g");
  bar->GetPositionCoordinate()->SetCoordinateSystemToNormalizedViewport();
  bar->SetPosition(0.88, 0.12);
  bar->SetWidth(0.09);
  bar->SetHeight(0.7);
  bar->SetBarRatio(0.3);
  bar->UnconstrainedFontSizeOn();
  auto* labels = bar->GetLabelTextProperty();
  labels->SetFontSize(static_cast<int>(text_size(overlay, 0.024)));
  labels->SetColor(0.0, 0.0, 0.0);
  labels->ItalicOff();
  labels->BoldOff();
  labels->ShadowOff();
  overlay->AddActor2D(bar);
  const auto text = add_text(overlay, title, {0.98 * size[0], 0.84 * size[1]}, text_size(overlay, 0.026));
  text->GetTextProperty()->SetJustificationToRight();
}

void add_legend(vtkRenderer* overlay, const std::vector<Category>& categories) {
  const auto* size = overlay->GetSize();
  const double line = text_size(overlay, 0.045);
  std::size_t longest = 0;
  for (const auto& category : categories) longest = std::max(longest, category.name.size());
  // A letter is about 0.55 of the font's size wide; a long name moves the legend to the left.
  const double width = 0.7 * line + 0.55 * text_size(overlay, 0.026) * static_cast<double>(longest);
  const double left = std::min(0.87 * size[0], 0.985 * size[0] - width);
  const double top = 0.8 * size[1], bottom = 0.1 * size[1];
  const auto room = static_cast<std::size_t>((top - bottom) / line);
  const std::size_t named = categories.size() > room ? room - 1 : categories.size();
  const auto write = [&](const std::string& words, const Pixel& at) {
    const auto text = add_text(overlay, words, {at.x + 0.7 * line, at.y}, text_size(overlay, 0.026));
    text->GetTextProperty()->SetVerticalJustificationToCentered();
  };
  for (std::size_t k = 0; k < named; ++k) {
    const Pixel at{left, top - line * static_cast<double>(k)};
    add_lines(overlay, {{at, {at.x + 0.5 * line, at.y}}}, 0.5 * line, categories[k].colour);
    write(categories[k].name, at);
  }
  if (named < categories.size())
    write(fmt::format("and {} more", categories.size() - named), {left, top - line * static_cast<double>(named)});
}

void add_scale_bar(vtkRenderer* overlay, vtkRenderer* scene) {
  const auto* size = overlay->GetSize();
  const double metres_per_pixel = 2.0 * scene->GetActiveCamera()->GetParallelScale() / scene->GetSize()[1];
  const double length = round_length(0.2 * scene->GetSize()[0] * metres_per_pixel);
  const double pixels = length / metres_per_pixel;
  const Pixel from{0.03 * size[0], 0.045 * size[1]};
  const Pixel to{from.x + pixels, from.y};
  const double tick = text_size(overlay, 0.01);
  add_lines(
      overlay,
      {{from, to}, {{from.x, from.y - tick}, {from.x, from.y + tick}}, {{to.x, to.y - tick}, {to.x, to.y + tick}}}, 3.0,
      {0.0, 0.0, 0.0});
  const auto unit = shown_unit(length, "m");
  const auto text = add_text(overlay, fmt::format("{:.3g} {}", length * unit.factor, unit.label),
                             {to.x + 2.0 * tick, to.y}, text_size(overlay, 0.026));
  text->GetTextProperty()->SetVerticalJustificationToCentered();
}

void add_dimension_lines(vtkRenderer* scene, const std::vector<DimensionLine>& lines) {
  const double step = text_size(scene, 0.05);
  std::vector<Segment> placed;
  for (const auto& line : lines) {
    const auto direction = line.segment.to - line.segment.from;
    const auto parallel = [&](const Segment& other) {
      const auto along = other.to - other.from;
      return std::abs(dot(along, direction)) > 0.99 * norm(along) * norm(direction);
    };
    const auto before = std::count_if(placed.begin(), placed.end(), parallel);
    placed.push_back(line.segment);
    add_dimension_line(scene, to_pixel(scene, line.segment.from), to_pixel(scene, line.segment.to),
                       step * static_cast<double>(before), line.label);
  }
}

}  // namespace tektite
