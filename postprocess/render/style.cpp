#include "postprocess/render/style.hpp"

#include <vtkAxis.h>
#include <vtkChartLegend.h>
#include <vtkChartXY.h>
#include <vtkPen.h>
#include <vtkTextProperty.h>

namespace tektite {

void style_chart(vtkChartXY* chart, const std::string& title) {
  chart->SetTitle(title);
  chart->GetTitleProperties()->SetFontSize(32);
  chart->SetShowLegend(true);
  chart->GetLegend()->SetLabelSize(24);
  chart->GetLegend()->SetInline(false);
}

void style_axis(vtkAxis* axis, const std::string& title) {
  axis->SetTitle(title);
  axis->GetTitleProperties()->SetFontSize(26);
  axis->GetTitleProperties()->SetBold(0);
  axis->GetLabelProperties()->SetFontSize(22);
  axis->GetGridPen()->SetColor(225, 225, 225);
}

}  // namespace tektite
