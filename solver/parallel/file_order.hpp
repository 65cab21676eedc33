#pragma once

#include "core/hdf5.hpp"
#include "core/particles.hpp"

namespace tektite {

/// Some rows of a file: the particles of all ranks stand in it in the order in which a single process has them.
struct FileRows {
  Particles particles;
  std::vector<Body> bodies;  ///< with their rows in the file
  hdf5::Rows rows;           ///< which these particles are
};

/// Brings what each rank owns to the rank that writes it: about as many rows each, one rank's behind the other's.
FileRows in_file_order(const Particles& particles);

}  // namespace tektite
