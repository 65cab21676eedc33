#pragma once
// How charts look.

#include <string>

class vtkAxis;
class vtkChartXY;

namespace tektite {

/// Title, and a legend beside the lines, not over them.
void style_chart(vtkChartXY* chart, const std::string& title);
void style_axis(vtkAxis* axis, const std::string& title);

}  // namespace tektite
