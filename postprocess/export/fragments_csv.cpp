#include "postprocess/export/fragments_csv.hpp"

#include <fmt/format.h>

#include "core/write_beside.hpp"

namespace tektite {

void write_fragments(const Whole& whole, const Fragments& fragments, const std::string& path) {
  constexpr std::string_view axes = "xyz";
  const auto width = static_cast<std::size_t>(whole.dimensions);
  std::string text = "fragment,body,particles,mass";
  for (const auto* name : {"centre", "velocity"})
    for (std::size_t k = 0; k < width; ++k) text += fmt::format(",{}_{}", name, axes[k]);
  text += '\n';
  for (std::size_t n = 0; n < fragments.list.size(); ++n) {
    const auto& fragment = fragments.list[n];
    text += fmt::format("{},{},{},{}", n, whole.bodies[static_cast<std::size_t>(fragment.body)].name, fragment.count,
                        fragment.mass);
    for (const auto& vector : {fragment.centre, fragment.velocity})
      for (std::size_t k = 0; k < width; ++k) text += fmt::format(",{}", vector[static_cast<int>(k)]);
    text += '\n';
  }
  write_text_beside(path, text);
}

}  // namespace tektite
