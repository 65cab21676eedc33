#pragma once
// The stage from end to end.

#include <string>
#include <vector>

namespace tektite {

struct PostprocessOptions {
  std::string run;                    ///< the folder of a run, or one particle file
  std::string output;                 ///< where results go; the run's folder where it is empty
  std::string scene;                  ///< a scene file with other measures and pictures; empty: that of the run
  std::string variant;                ///< of that scene file; picks the references. Empty: that of the run
  std::vector<std::string> settings;  ///< KEY=VALUE laid over the scene file
  std::string reference;              ///< a file of published values; empty: none
  bool pictures = true;
};

/// Writes vtu/, NAME.pvd, fragments.csv, measurements.json and pictures/, and prints the table of ours beside
/// published. Pictures that cannot be drawn are a warning. Throws InputError and RunError.
void postprocess(const PostprocessOptions& options);

/// Validates what postprocess reads of a scene file and says it in words.
void check_scene(const PostprocessOptions& options);

}  // namespace tektite
