#include "parallel/threads.hpp"

#include <omp.h>
#include <unistd.h>

#include <algorithm>
#include <cstdlib>
#include <filesystem>
#include <system_error>

namespace tektite {

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
  if (!none) ::execv(program.c_str(), argv);  // comes back only where it cannot, and then all goes on as it was
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
