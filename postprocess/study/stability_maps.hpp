#pragma once
// What the analysis of a study of stability has left, as pictures.

#include <string>

namespace tektite {

/// Draws DIR/growth.png (growth over h/δ and stress), DIR/waves.png (over direction and wave number) and DIR/strain.png
/// (the share of the strain that is seen) from DIR/growth.csv and DIR/waves.csv. On growth.png are drawn, dashed, no
/// stress, and the h/δ at which W'' of the nearest neighbours changes its sign. Throws InputError.
void draw_stability(const std::string& study_file, const std::string& folder);

}  // namespace tektite
