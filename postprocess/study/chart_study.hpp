#pragma once
// A study that has been run, as numbers, pictures and words.

#include <string>

namespace tektite {

/// Validates the study file and everything that its runs are judged by. Throws InputError.
void check_study(const std::string& path);

/// Charts the runs that DIR/runs holds: writes DIR/chart.csv, chart.md, chart.svg and chart.png, and prints the page.
/// False where no run has a result. Throws InputError.
bool chart_study(const std::string& path, const std::string& folder);

}  // namespace tektite
