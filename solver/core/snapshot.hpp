#pragma once
// The one schema of particle files: the initial state that preprocess writes and the snapshots that solver writes.
//
//   /                @format "tektite particles", @format_version, @tektite_version, @space
//   /scene           the effective scene as TOML
//   /state           @time and every other number of the run's state
//   /bodies/NNNN     @name @material @spacing @first @count
//   /particles/FIELD (count) or (count, components), with @unit and @symbol

#include <map>
#include <string>

#include "core/document.hpp"
#include "core/particles.hpp"

namespace tektite {

struct Snapshot {
  Particles particles;
  std::map<std::string, double> state;  ///< numbers by name; "time" in s is always there
  std::string scene;                    ///< the effective scene as TOML

  double time() const { return state.at("time"); }
};

inline constexpr int particle_format_version = 1;

/// Writes beside and renames, so that `path` is either whole or as it was. Throws RunError.
void write_snapshot(const Snapshot& snapshot, const std::string& path);

/// Throws InputError where the file is missing, foreign, newer than this program, or broken.
Snapshot read_snapshot(const std::string& path);

}  // namespace tektite
