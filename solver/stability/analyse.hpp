#pragma once

#include <string>

namespace tektite {

/// Analyses every line of a study of stability, prints what it finds, and leaves in `folder`, made where it is missing,
///   growth.csv   the fastest growth over stress and h/δ, at the time step in use, and Swegle's sign for the nearest
///                neighbours
///   waves.csv    growth, frequency and share of the strain that is seen, over wave number and direction, where the
///                study shows them
///   steps.csv    the largest stable time step beside that in use, without stress
/// A state that a material cannot be in, or a scheme not start from, has no numbers (nan), and a line says why.
/// `threads`: 0 for all that there are. Throws InputError.
void analyse_stability(const std::string& study_file, const std::string& folder, int threads);

}  // namespace tektite
