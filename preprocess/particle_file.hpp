#pragma once

#include <string>

#include "preprocess/build_particles.hpp"

namespace tektite::preprocess {

/// Writes what was built beside its place and renames it. All ranks write one file together, the same as a single
/// process. Throws RunError.
void write_particle_file(const Result& result, const std::string& path);

}  // namespace tektite::preprocess
