#include "parallel/threads.hpp"

#include <omp.h>
#include <sched.h>
#include <unistd.h>

#include <algorithm>
#include <cstdlib>
#include <filesystem>
#include <system_error>
#include <vector>

namespace tektite {
namespace {

/// OpenMP that binds its threads, as OMP_PROC_BIND and OMP_PLACES ask for, has bound this one as the program was
/// loaded. The same program started again would know of no processor but that one, so this gives it back those of all
/// places.
void unbind() {
  cpu_set_t processors;
  CPU_ZERO(&processors);
  for (int place = 0; place < omp_get_num_places(); ++place) {
    std::vector<int> ids(static_cast<std::size_t>(omp_get_place_num_procs(place)));
    omp_get_place_proc_ids(place, ids.data());
    for (const int id : ids) CPU_SET(static_cast<std::size_t>(id), &processors);
  }
  if (CPU_COUNT(&processors) > 0) ::sched_setaffinity(0, sizeof processors, &processors);
}

}  // namespace

void wait_briefly(char** argv) {
  // Long enough for the few microseconds between the loops of a step. Measured on two cores: with 300 to 3000 a step is
  // as fast as with OpenMP's own 300 000 where nothing else runs.
  constexpr const char* turns = "1000";
  // NOLINTBEGIN(concurrency-mt-unsafe): nothing else runs yet
  if (std::getenv("OMP_WAIT_POLICY") || std::getenv("GOMP_SPINCOUNT")) return;
  if (::setenv("GOMP_SPINCOUNT", turns, 0) != 0) return;
  // NOLINTEND(concurrency-mt-unsafe)
  std::error_code none;
  const auto program = std::filesystem::read_symlink("/proc/self/exe", none);  // under its own name for ps and kill
  if (none) return;
  unbind();
  ::execv(program.c_str(), argv);  // comes back only where it cannot, and then all goes on as it was
}

void use_threads(int wanted) {
  if (wanted > 0) omp_set_num_threads(wanted);
}

void use_threads(int wanted, std::size_t particles) {
  constexpr std::size_t least_particles = 500;
  const auto all = static_cast<std::size_t>(omp_get_max_threads());
  use_threads(wanted > 0 ? wanted : static_cast<int>(std::clamp<std::size_t>(particles / least_particles, 1, all)));
}

int threads_in_use() { return omp_get_max_threads(); }

}  // namespace tektite
