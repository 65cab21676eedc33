// Any bytes as a surface mesh: refused by an InputError, or a solid that encloses a finite volume.
#include <cmath>
#include <cstdlib>
#include <string_view>

#include "fuzz/file_of.hpp"
#include "preprocess/geometry/mesh_file.hpp"

using namespace tektite;

namespace {

/// The kind of mesh that the bytes begin like.
const char* ending_of(std::string_view bytes) {
  if (bytes.starts_with("OFF")) return ".off";
  if (bytes.starts_with("ply")) return ".ply";
  if (bytes.starts_with("v ") || bytes.starts_with("#")) return ".obj";
  return ".stl";
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const test::FileOf file(data, size, ending_of({reinterpret_cast<const char*>(data), size}));
  try {
    const auto mesh = preprocess::read_mesh_file(file.path(), 1e-3);
    if (!std::isfinite(mesh.surface.volume())) std::abort();
  } catch (const InputError&) {
  }
  return 0;
}
