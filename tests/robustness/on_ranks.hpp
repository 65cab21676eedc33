#pragma once
// Programs as several processes of mpirun.

#include <string>
#include <vector>

namespace tektite::test {

/// Started as so many processes; on one machine, however many processors it has, which who waits leaves to others. The
/// launcher does not look for graphics cards at X servers, which are those of other tests and go away.
inline std::vector<std::string> on_ranks(int ranks, std::vector<std::string> words) {
  words.insert(words.begin(), {"/usr/bin/env", "HWLOC_COMPONENTS=-gl", "OMPI_MCA_mpi_yield_when_idle=1", MPI_LAUNCHER,
                               "--oversubscribe", "--allow-run-as-root", "-n", std::to_string(ranks)});
  return words;
}

/// How often a text stands in another one.
inline int count_of(const std::string& text, const std::string& within) {
  int count = 0;
  for (auto at = within.find(text); at != std::string::npos; at = within.find(text, at + 1)) ++count;
  return count;
}

}  // namespace tektite::test
