// Any text is a scene or an InputError, and an effective scene reads as itself.
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <string>

#include "core/error.hpp"
#include "core/scene.hpp"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace tektite;
  const std::string text(reinterpret_cast<const char*>(data), size);
  try {
    auto document = Document::parse(text, "scene.toml");
    auto root = document.root();
    const auto scene = read_scene(root, Stage::postprocess);
    auto again = Document::parse(document.text(), "scene.toml");
    auto root_again = again.root();
    if (read_scene(root_again, Stage::postprocess).name != scene.name || again.text() != document.text()) std::abort();
    root.finish();
  } catch (const InputError&) {
  }
  return 0;
}
