#pragma once

#include <memory>

#include "core/hdf5.hpp"

namespace tektite {

/// A file that all ranks write together, by parallel HDF5.
std::unique_ptr<hdf5::Together> file_of_all_ranks();

}  // namespace tektite
