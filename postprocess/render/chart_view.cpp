#include "postprocess/render/chart_view.hpp"

#include <vtkAxis.h>
#include <vtkChartLegend.h>
#include <vtkContextScene.h>
#include <vtkPen.h>
#include <vtkRenderWindow.h>
#include <vtkRenderer.h>
#include <vtkTextProperty.h>

namespace tektite {
namespace {

void style_axis(vtkAxis* axis, const std::string& title) {
  axis->SetTitle(title);
  axis->GetTitleProperties()->SetFontSize(26);
  axis->GetTitleProperties()->SetBold(0);
  axis->GetLabelProperties()->SetFontSize(22);
  axis->GetGridPen()->SetColor(225, 225, 225);
}

}  // namespace

ChartView make_chart_view(int width, int height, const std::string& title, const std::string& x_title,
                          const std::string& y_title) {
  ChartView made{vtkSmartPointer<vtkContextView>::New(), vtkSmartPointer<vtkChartXY>::New()};
  auto* window = made.view->GetRenderWindow();
  window->SetOffScreenRendering(1);
  window->SetSize(width, height);
  window->SetMultiSamples(8);
  made.view->GetRenderer()->SetBackground(1.0, 1.0, 1.0);
  made.view->GetScene()->AddItem(made.chart);
  made.chart->SetTitle(title);
  made.chart->GetTitleProperties()->SetFontSize(32);
  made.chart->SetShowLegend(true);
  made.chart->GetLegend()->SetLabelSize(24);
  made.chart->GetLegend()->SetInline(false);
  style_axis(made.chart->GetAxis(vtkAxis::BOTTOM), x_title);
  style_axis(made.chart->GetAxis(vtkAxis::LEFT), y_title);
  return made;
}

}  // namespace tektite
