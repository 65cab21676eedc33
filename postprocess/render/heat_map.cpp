#include "postprocess/render/heat_map.hpp"

#include <fmt/format.h>
#include <vtkBrush.h>
#include <vtkContext2D.h>
#include <vtkContextItem.h>
#include <vtkContextScene.h>
#include <vtkContextView.h>
#include <vtkObjectFactory.h>
#include <vtkPen.h>
#include <vtkRenderWindow.h>
#include <vtkRenderer.h>
#include <vtkStdString.h>
#include <vtkTextProperty.h>

#include <algorithm>
#include <cmath>

#include "postprocess/render/colours.hpp"
#include "postprocess/render/image.hpp"

namespace tektite {
namespace {

// In pixels.
constexpr float panel_width = 330.0F, panel_height = 250.0F, left = 95.0F, below = 75.0F, right = 25.0F, above = 55.0F;
constexpr float scale_width = 170.0F, head = 60.0F;
constexpr int most_columns = 4;

struct Box {
  float x, y, width, height;
};

/// The cells' edges: half a cell beyond the first and the last.
struct Axis {
  double least, cell;
  std::size_t cells;
  explicit Axis(const std::vector<double>& centres)
      : cell(centres.size() > 1 ? (centres.back() - centres.front()) / static_cast<double>(centres.size() - 1) : 1.0),
        cells(centres.size()) {
    least = centres.front() - 0.5 * cell;
  }
  double part(double value) const { return (value - least) / (cell * static_cast<double>(cells)); }
};

class HeatMapItem : public vtkContextItem {
 public:
  vtkTypeMacro(HeatMapItem, vtkContextItem);
  static HeatMapItem* New();

  HeatMap map;

  bool Paint(vtkContext2D* painter) override {
    const auto columns = std::min<std::size_t>(most_columns, map.panels.size());
    const auto rows = (map.panels.size() + columns - 1) / columns;
    const float step_x = left + panel_width + right, step_y = below + panel_height + above;
    for (std::size_t k = 0; k < map.panels.size(); ++k) {
      const std::size_t row = rows - 1 - k / columns;
      paint_panel(painter, map.panels[k],
                  {static_cast<float>(k % columns) * step_x + left, static_cast<float>(row) * step_y + below,
                   panel_width, panel_height});
    }
    const float height = static_cast<float>(rows) * step_y;
    paint_scale(painter, {static_cast<float>(columns) * step_x + 10.0F, below, 25.0F, height - below - above});
    write(painter, 0.5F * static_cast<float>(columns) * step_x, height + 0.4F * head, map.title, 26, true);
    return true;
  }

 private:
  void colour(vtkContext2D* painter, double value) const {
    painter->GetPen()->SetLineType(vtkPen::NO_PEN);
    if (std::isnan(value)) {
      painter->GetBrush()->SetColor(200, 200, 200, 255);
    } else if (value <= map.level) {
      painter->GetBrush()->SetColor(255, 255, 255, 255);
    } else {
      const auto& [red, green, blue] = continuous_colour(value / map.largest);
      painter->GetBrush()->SetColorF(red, green, blue);
    }
  }

  static void write(vtkContext2D* painter, float x, float y, const std::string& text, int size, bool centred,
                    double turn = 0.0) {
    auto* style = painter->GetTextProp();
    style->SetFontSize(size);
    style->SetColor(0.0, 0.0, 0.0);
    style->SetOrientation(turn);
    style->SetVerticalJustificationToCentered();
    if (centred)
      style->SetJustificationToCentered();
    else
      style->SetJustificationToLeft();
    painter->DrawString(x, y, text);
  }

  static void line(vtkContext2D* painter, int type, float width) {
    painter->GetPen()->SetLineType(type);
    painter->GetPen()->SetColor(0, 0, 0, 255);
    painter->GetPen()->SetWidth(width);
  }

  void paint_panel(vtkContext2D* painter, const HeatPanel& panel, const Box& box) const {
    const Axis x(panel.x), y(panel.y);
    const float w = box.width / static_cast<float>(x.cells), h = box.height / static_cast<float>(y.cells);
    for (std::size_t i = 0; i < x.cells; ++i)
      for (std::size_t j = 0; j < y.cells; ++j) {
        colour(painter, panel.values[i * y.cells + j]);
        painter->DrawRect(box.x + static_cast<float>(i) * w, box.y + static_cast<float>(j) * h, w, h);
      }
    const auto at_x = [&](double value) { return box.x + box.width * static_cast<float>(x.part(value)); };
    const auto at_y = [&](double value) { return box.y + box.height * static_cast<float>(y.part(value)); };
    line(painter, vtkPen::DASH_LINE, 2.0F);
    for (const auto& c : panel.across) painter->DrawLine(at_x(c[0]), at_y(c[1]), at_x(c[0]), at_y(c[2]));
    for (const auto& c : panel.along) painter->DrawLine(at_x(c[1]), at_y(c[0]), at_x(c[2]), at_y(c[0]));
    line(painter, vtkPen::SOLID_LINE, 1.5F);
    painter->GetBrush()->SetColor(0, 0, 0, 0);
    painter->DrawRect(box.x, box.y, box.width, box.height);
    for (const auto k : {std::size_t{0}, x.cells / 2, x.cells - 1})
      write(painter, at_x(panel.x[k]), box.y - 16.0F, fmt::format("{:.3g}", panel.x[k]), 17, true);
    for (const auto k : {std::size_t{0}, y.cells / 2, y.cells - 1})
      write(painter, box.x - 26.0F, at_y(panel.y[k]), fmt::format("{:.3g}", panel.y[k]), 17, true);
    write(painter, box.x + 0.5F * box.width, box.y - 44.0F, map.x_title, 19, true);
    write(painter, box.x - 66.0F, box.y + 0.5F * box.height, map.y_title, 19, true, 90.0);
    write(painter, box.x + 0.5F * box.width, box.y + box.height + 20.0F, panel.title, 20, true);
  }

  void paint_scale(vtkContext2D* painter, const Box& box) const {
    constexpr int steps = 100;
    const float h = box.height / steps;
    for (int k = 0; k < steps; ++k) {
      colour(painter, map.largest * (k + 0.5) / steps);
      painter->DrawRect(box.x, box.y + static_cast<float>(k) * h, box.width, h + 0.5F);
    }
    line(painter, vtkPen::SOLID_LINE, 1.5F);
    painter->GetBrush()->SetColor(0, 0, 0, 0);
    painter->DrawRect(box.x, box.y, box.width, box.height);
    for (const double part : {0.0, 0.25, 0.5, 0.75, 1.0})
      write(painter, box.x + box.width + 8.0F, box.y + box.height * static_cast<float>(part),
            fmt::format("{:.2g}{}", part * map.largest, part == 1.0 ? " and more" : ""), 17, false);
    write(painter, box.x + box.width + 100.0F, box.y + 0.5F * box.height, map.value_title, 19, true, 90.0);
  }
};
vtkStandardNewMacro(HeatMapItem);

}  // namespace

void draw_heat_map(const HeatMap& map, const std::string& path) {
  const auto columns = std::min<std::size_t>(most_columns, map.panels.size());
  const auto rows = (map.panels.size() + columns - 1) / columns;
  const auto view = vtkSmartPointer<vtkContextView>::New();
  auto* window = view->GetRenderWindow();
  window->SetOffScreenRendering(1);
  window->SetMultiSamples(0);
  window->SetSize(static_cast<int>(static_cast<float>(columns) * (left + panel_width + right) + scale_width),
                  static_cast<int>(static_cast<float>(rows) * (below + panel_height + above) + head));
  view->GetRenderer()->SetBackground(1.0, 1.0, 1.0);
  const auto item = vtkSmartPointer<HeatMapItem>::New();
  item->map = map;
  view->GetScene()->AddItem(item);
  write_png(window, path);
}

}  // namespace tektite
