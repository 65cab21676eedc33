#pragma once
// A study as the stages share it: which scenes are run, with what laid over them, at which resolutions. What the runs
// are judged by is read by postprocess alone.
//
//   name = "flyer_plate"
//   scene = "../flyer_plate/scene.toml"          # relative to the study
//   set = ["output.history=100"]                 # as --set, over every scene
//   resolutions = [{ factor = 2 }, { factor = 1 }]
//   [line.split1]
//   variant = "split1"

#include <string>
#include <vector>

#include "core/document.hpp"

namespace tektite {

/// One run of a study.
struct Member {
  std::string name;  ///< LINE-FACTOR: names its folder
  double factor = 1.0;
  double spacing = 0.0;               ///< factor times that of the scene, in m
  std::string scene;                  ///< path of the scene file
  std::string variant;                ///< empty where there is none
  std::vector<std::string> settings;  ///< KEY=VALUE, the spacing among them

  Document load() const { return Document::load(scene, variant, settings); }
};

/// Runs that differ in their resolution alone.
struct StudyLine {
  std::string name;
  std::string title;
  std::vector<Member> members;  ///< at least one, coarsest first
};

struct Study {
  std::string name;
  std::string title;
  std::vector<StudyLine> lines;  ///< in the order of the file, at least one
};

/// Reads what all stages need and leaves the keys that postprocess owns (error, combine, target). Every scene is loaded
/// to find its spacing. Throws InputError.
Study read_study(Section& root);

}  // namespace tektite
