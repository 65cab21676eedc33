#pragma once
// From a render window to a PNG file.

#include <string>

class vtkRenderWindow;

namespace tektite {

/// Renders and writes the picture beside its place, then renames. Throws RunError.
void write_png(vtkRenderWindow* window, const std::string& path);

}  // namespace tektite
