#pragma once
// From a render window to a PNG file.

#include <string>

class vtkContextView;
class vtkRenderWindow;

namespace tektite {

/// Renders and writes the picture beside its place, then renames. Throws RunError.
void write_png(vtkRenderWindow* window, const std::string& path);

/// The same of a chart, which lays out its axes by what its first drawing tells, so it is drawn twice.
void write_png(vtkContextView* chart, const std::string& path);

}  // namespace tektite
