#pragma once
// A chart on white paper, off screen, and how it looks.

#include <vtkChartXY.h>
#include <vtkContextView.h>
#include <vtkSmartPointer.h>

#include <string>

namespace tektite {

struct ChartView {
  vtkSmartPointer<vtkContextView> view;
  vtkSmartPointer<vtkChartXY> chart;
};

/// Titles, and a legend beside the lines, not over them. Size in pixels.
ChartView make_chart_view(int width, int height, const std::string& title, const std::string& x_title,
                          const std::string& y_title);

}  // namespace tektite
