#pragma once

#include <string>

#include "run/run_settings.hpp"

namespace tektite::test {

/// Of a scene that needs no name.
inline RunSettings settings_of(const std::string& scene) {
  auto document = Document::parse("name = 'test'\n" + scene, "test scene");
  return read_run_settings(document);
}

}  // namespace tektite::test
