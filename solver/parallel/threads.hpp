#pragma once
// How many threads compute, and how they wait for each other.

#include <cstddef>

namespace tektite {

/// Threads that come to the end of a loop first wait for the others. OpenMP lets them turn on their processor for
/// milliseconds, which on a machine that others use too keeps those from computing for whom they wait: two runs at once
/// on two processors then take six times as long as with this. Read by OpenMP as the program is loaded, so the first
/// call starts the program again with it, in the same process; what the user has set in OMP_WAIT_POLICY or
/// GOMP_SPINCOUNT stands. To be called before anything else.
void wait_briefly(char** argv);

/// So many threads from now on; 0 leaves it at all processors (or what OMP_NUM_THREADS says).
void use_threads(int wanted);

/// No more threads than have five hundred of these particles each, and at least one, where none are `wanted` by number:
/// a loop over fewer is over before another thread has begun.
void use_threads(int wanted, std::size_t particles);

int threads_in_use();

/// work() once on every thread that computes.
template <class Work>
void on_every_thread(const Work& work) {
#pragma omp parallel
  work();
}

}  // namespace tektite
