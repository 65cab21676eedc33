#pragma once

namespace tektite {

/// From now on the first division by zero, overflow or undefined result (0/0, the root of a negative number) of any
/// thread ends the program with exit code 1, what it was and where on standard error. For whoever writes a formula:
/// without it such a number is found at the end of the step, as a state that is no longer sane.
void trap_floating_point();

}  // namespace tektite
