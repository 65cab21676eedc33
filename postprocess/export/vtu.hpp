#pragma once
// Files for ParaView.

#include <string>
#include <vector>

class vtkUnstructuredGrid;

namespace tektite {

/// Writes a grid of make_grid() as compressed binary VTU. Throws RunError.
void write_vtu(vtkUnstructuredGrid* grid, const std::string& path);

/// Writes the file that joins pieces, whose paths are relative to its folder: grids with the arrays of `grid`, which is
/// one of them. Throws RunError.
void write_pvtu(vtkUnstructuredGrid* grid, const std::vector<std::string>& pieces, const std::string& path);

struct TimedFile {
  double time = 0.0;  ///< in s
  std::string path;   ///< relative to the folder of the collection
};

/// Writes the collection that ParaView opens; times have all their digits. Throws RunError.
void write_pvd(const std::vector<TimedFile>& files, const std::string& path);

}  // namespace tektite
