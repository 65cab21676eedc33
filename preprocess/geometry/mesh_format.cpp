#include "preprocess/geometry/mesh_format.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cctype>
#include <cstdint>
#include <cstring>
#include <filesystem>
#include <fstream>

namespace tektite::preprocess {
namespace {

// A binary STL file: 80 bytes of anything, the number of faces in 4 bytes, 50 bytes a face.
constexpr std::uintmax_t stl_header = 84;
constexpr std::uintmax_t stl_face = 50;

void check_stl_length(const std::string& path) {
  std::ifstream file(path, std::ios::binary);
  std::array<char, stl_header> header{};
  file.read(header.data(), header.size());
  const auto read = static_cast<std::size_t>(file.gcount());
  std::string word(header.data(), std::min<std::size_t>(read, 5));
  if (word == "solid") return;  // most likely ascii
  std::uint32_t faces = 0;
  std::memcpy(&faces, header.data() + 80, sizeof faces);
  const auto expected = stl_header + stl_face * faces;
  const auto there = std::filesystem::file_size(path);
  const bool whole = read >= stl_header && there >= expected;
  std::transform(word.begin(), word.end(), word.begin(), [](unsigned char letter) { return std::tolower(letter); });
  if (!whole && word == "solid")
    throw mesh_fault(path, "an ASCII STL file has its words in small letters", "solid, facet, vertex, ...");
  if (!whole)
    throw mesh_fault(path, fmt::format("the file is cut short: {} bytes of {}", there, expected), "a whole STL file");
}

}  // namespace

InputError mesh_fault(const std::string& path, const std::string& reason, const std::string& allowed) {
  return InputError({{path, 0}, {}, {}, reason, allowed});
}

void check_mesh_format(const std::string& path) {
  if (!std::filesystem::exists(path)) throw mesh_fault(path, "there is no such mesh file", {});
  if (!std::filesystem::is_regular_file(path)) throw mesh_fault(path, "this is no file", "a mesh file");
  if (std::filesystem::file_size(path) == 0) throw mesh_fault(path, "the mesh file is empty", "a closed surface");
  auto ending = std::filesystem::path(path).extension().string();
  for (auto& letter : ending) letter = static_cast<char>(std::tolower(static_cast<unsigned char>(letter)));
  constexpr std::array<std::string_view, 4> known{".stl", ".off", ".obj", ".ply"};
  if (std::find(known.begin(), known.end(), ending) == known.end())
    throw mesh_fault(path, fmt::format("unknown kind of mesh file \"{}\"", ending), ".stl, .off, .obj, .ply");
  if (ending == ".stl") check_stl_length(path);
}

}  // namespace tektite::preprocess
