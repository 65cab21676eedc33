// Any bytes as a scene: it is refused by an InputError, or read; and what was read is a scene that reads the same.
#include <cstdlib>

#include "fuzz/file_of.hpp"
#include "run/run_settings.hpp"

using namespace tektite;

namespace {

/// What a later stage reads is the effective scene.
void read_effective(Document document) {
  read_run_settings(document);
  const auto text = document.text();
  auto again = Document::parse(text, "effective.toml");
  read_run_settings(again);
  if (again.text() != text) std::abort();
}

}  // namespace

/// A scene; behind a zero byte it may be followed by a setting KEY=VALUE.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const std::string_view bytes(reinterpret_cast<const char*>(data), size);
  const auto end = std::min(bytes.find('\0'), size);
  std::vector<std::string> settings;
  if (end < size) settings.emplace_back(bytes.substr(end + 1));
  const test::FileOf file(data, end, ".toml");
  try {
    const auto plain = Document::load(file.path(), "", settings);
    read_effective(plain);
    for (const auto& variant : plain.variants()) read_effective(Document::load(file.path(), variant, settings));
  } catch (const InputError&) {
  }
  return 0;
}
