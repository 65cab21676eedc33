#include "postprocess/export/pieces.hpp"

#include <fmt/format.h>
#include <vtkUnstructuredGrid.h>

#include <algorithm>
#include <filesystem>
#include <vector>

#include "core/hdf5.hpp"
#include "postprocess/export/grid.hpp"

namespace tektite {
namespace {

namespace fs = std::filesystem;

/// Some rows of the file as a grid.
vtkSmartPointer<vtkUnstructuredGrid> grid_of(const std::string& file, std::size_t first, std::size_t count) {
  return make_grid(read_rows(
      file, [&](std::size_t all) { return hdf5::Rows(first, count, all); }, exported_fields()));
}

void remove_all_but(const std::vector<std::string>& kept, const fs::path& folder) {
  std::vector<fs::path> others;
  for (const auto& entry : fs::directory_iterator(folder))
    if (std::ranges::find(kept, entry.path().filename().string()) == kept.end()) others.push_back(entry.path());
  for (const auto& other : others) fs::remove(other);
}

/// The file that joins them is there only while all of them are.
void write_pieces(const std::string& file, const fs::path& folder, const std::string& name, std::size_t count,
                  std::size_t most) {
  const auto joined = folder / (name + ".pvtu");
  fs::remove(joined);
  std::vector<std::string> pieces, paths;
  vtkSmartPointer<vtkUnstructuredGrid> grid;
  for (std::size_t first = 0; first < count; first += most) {
    pieces.push_back(fmt::format("{:04}.vtu", pieces.size()));
    paths.push_back(name + '/' + pieces.back());
    grid = nullptr;
    grid = grid_of(file, first, std::min(most, count - first));
    write_vtu(grid, (folder / paths.back()).string());
  }
  write_pvtu(grid, paths, joined.string());
  remove_all_but(pieces, folder / name);
  fs::remove(folder / (name + ".vtu"));
}

}  // namespace

TimedFile export_particles(const std::string& file, const std::string& folder, std::size_t most) {
  const auto beside_particles = read_fields(file, {});
  const auto count = beside_particles.particles.count();
  const auto name = fs::path(file).stem().string();
  if (count > most) {
    write_pieces(file, folder, name, count, most);
    return {beside_particles.time(), name + ".pvtu"};
  }
  write_vtu(grid_of(file, 0, count), (fs::path(folder) / (name + ".vtu")).string());
  fs::remove(fs::path(folder) / (name + ".pvtu"));
  fs::remove_all(fs::path(folder) / name);
  return {beside_particles.time(), name + ".vtu"};
}

}  // namespace tektite
