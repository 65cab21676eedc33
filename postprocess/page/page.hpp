#pragma once
// One page about one run, or about several side by side.

#include <string>
#include <vector>

#include "postprocess/page/run_data.hpp"

namespace tektite {

/// The page as HTML that is well-formed XML too and needs nothing but itself: style and pictures are within it.
std::string page_of(const std::vector<RunData>& runs);

/// Reads the folders and writes the page. Throws InputError, RunError.
void write_page(const std::vector<std::string>& folders, const std::string& path);

}  // namespace tektite
