#pragma once
// What can be told of a mesh file before it is parsed.

#include <string>

#include "core/error.hpp"

namespace tektite::preprocess {

/// The error for a mesh file.
InputError mesh_fault(const std::string& path, const std::string& reason, const std::string& allowed);

/// Throws InputError where the file is missing, is a folder, has an unknown ending, or is a binary STL that is not as
/// long as its own count of faces says.
void check_mesh_format(const std::string& path);

}  // namespace tektite::preprocess
