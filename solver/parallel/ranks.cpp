#include "parallel/ranks.hpp"

#include <chrono>
#include <cstdlib>
#include <stdexcept>
#include <string>
#include <thread>

#include "core/error.hpp"
#include "parallel/traffic.hpp"

#ifdef TEKTITE_MPI
#include <mpi.h>
#endif

namespace tektite {
namespace {

int this_rank = 0, all_ranks = 1;
bool dismissed = false;
std::size_t particles_of_all = 0;
Traffic so_far;

/// What launchers tell each process: how many there are, or its number alone.
bool started_by_launcher() {
  for (const char* name : {"OMPI_COMM_WORLD_SIZE", "PMI_SIZE", "PMIX_RANK", "PMI_RANK"})
    if (std::getenv(name)) return true;  // NOLINT(concurrency-mt-unsafe): nothing else runs yet
  return false;
}

#ifndef TEKTITE_MPI
int processes_started() {
  for (const char* name : {"OMPI_COMM_WORLD_SIZE", "PMI_SIZE"})
    if (const char* size = std::getenv(name)) return std::atoi(size);  // NOLINT(concurrency-mt-unsafe)
  return 1;
}
#endif

}  // namespace

const Traffic& traffic() { return so_far; }
int rank() { return this_rank; }
int ranks() { return all_ranks; }
void dismiss_ranks() { dismissed = true; }
std::size_t count_of_all(const Particles& particles) {
  return distributed(particles) ? particles_of_all : particles.count();
}
void wait_to_be_ended() {
  constexpr std::chrono::seconds patience(30);
  std::this_thread::sleep_for(patience);
}
void note_count_of_all(std::size_t count) { particles_of_all = count; }

#ifdef TEKTITE_MPI

namespace {

/// Counts the time until it is destroyed, with messages that are sent meanwhile.
class Talk {
 public:
  Talk(std::size_t messages, std::size_t bytes_each) : start_(Clock::now()) { count(messages, bytes_each); }
  ~Talk() { so_far.seconds += std::chrono::duration<double>(Clock::now() - start_).count(); }
  Talk(const Talk&) = delete;
  Talk& operator=(const Talk&) = delete;

  static void count(std::size_t messages, std::size_t bytes_each) {
    so_far.messages += messages;
    so_far.bytes += messages * bytes_each;
  }

 private:
  using Clock = std::chrono::steady_clock;
  Clock::time_point start_;
};

std::size_t others() { return static_cast<std::size_t>(all_ranks - 1); }

const Combine* combining = nullptr;  ///< of the reduction that is under way

void combine_values(void* part, void* whole, int* count, MPI_Datatype*) {
  (*combining)(part, whole, static_cast<std::size_t>(*count));
}

/// Messages are counted by int.
int count_of(const Words& words) {
  constexpr std::size_t most = (std::size_t{1} << 31) - 1;
  if (words.size() > most) throw std::length_error("more than 16 GB for one process: take more of them");
  return static_cast<int>(words.size());
}

}  // namespace

void begin_ranks() {
  if (!started_by_launcher()) return;
  // Open MPI looks for graphics cards at the X server, and a server that goes away meanwhile ends the process.
  ::setenv("HWLOC_COMPONENTS", "-gl", 0);  // NOLINT(concurrency-mt-unsafe): nothing else runs yet
  int level = 0;
  MPI_Init_thread(nullptr, nullptr, MPI_THREAD_FUNNELED, &level);
  MPI_Comm_rank(MPI_COMM_WORLD, &this_rank);
  MPI_Comm_size(MPI_COMM_WORLD, &all_ranks);
}

void leave_ranks(int code) {
  int begun = 0;
  MPI_Initialized(&begun);
  if (begun == 0) return;
  if (code != 0 && all_ranks > 1 && !dismissed) MPI_Abort(MPI_COMM_WORLD, code);
  MPI_Finalize();
}

void combine_over_ranks(void* values, std::size_t count, std::size_t size, const Combine& combine) {
  if (all_ranks == 1) return;
  const Talk talk(1, count * size);
  MPI_Datatype type{};
  MPI_Type_contiguous(static_cast<int>(size), MPI_BYTE, &type);
  MPI_Type_commit(&type);
  MPI_Op operation{};
  MPI_Op_create(combine_values, 1, &operation);
  combining = &combine;
  MPI_Allreduce(MPI_IN_PLACE, values, static_cast<int>(count), type, operation, MPI_COMM_WORLD);
  MPI_Op_free(&operation);
  MPI_Type_free(&type);
}

std::vector<Words> exchange_words(const std::vector<Words>& to) {
  std::vector<int> sent, coming(to.size());
  for (const auto& words : to) sent.push_back(count_of(words));
  {
    const Talk talk(others(), sizeof(int));
    MPI_Alltoall(sent.data(), 1, MPI_INT, coming.data(), 1, MPI_INT, MPI_COMM_WORLD);
  }
  std::vector<Words> from(to.size());
  for (std::size_t r = 0; r < from.size(); ++r) from[r].resize(static_cast<std::size_t>(coming[r]));
  exchange_words(to, from);
  return from;
}

void exchange_words(const std::vector<Words>& to, std::vector<Words>& from) {
  const Talk talk(0, 0);
  std::vector<MPI_Request> requests;
  for (std::size_t r = 0; r < from.size(); ++r)
    if (!from[r].empty())
      MPI_Irecv(from[r].data(), count_of(from[r]), MPI_UINT64_T, static_cast<int>(r), 0, MPI_COMM_WORLD,
                &requests.emplace_back());
  for (std::size_t r = 0; r < to.size(); ++r)
    if (!to[r].empty()) {
      if (static_cast<int>(r) != this_rank) Talk::count(1, to[r].size() * sizeof(Word));
      MPI_Isend(to[r].data(), count_of(to[r]), MPI_UINT64_T, static_cast<int>(r), 0, MPI_COMM_WORLD,
                &requests.emplace_back());
    }
  MPI_Waitall(static_cast<int>(requests.size()), requests.data(), MPI_STATUSES_IGNORE);
}

std::vector<Words> gather_on_all(const Words& own) {
  if (all_ranks == 1) return {own};
  std::vector<int> counts(static_cast<std::size_t>(all_ranks)), offsets;
  const int count = count_of(own);
  const Talk talk(others(), own.size() * sizeof(Word));
  MPI_Allgather(&count, 1, MPI_INT, counts.data(), 1, MPI_INT, MPI_COMM_WORLD);
  std::size_t sum = 0;
  for (const int one : counts) {
    offsets.push_back(static_cast<int>(sum));
    sum += static_cast<std::size_t>(one);
  }
  Words all(sum);
  count_of(all);
  MPI_Allgatherv(own.data(), count, MPI_UINT64_T, all.data(), counts.data(), offsets.data(), MPI_UINT64_T,
                 MPI_COMM_WORLD);
  std::vector<Words> each;
  for (std::size_t r = 0; r < counts.size(); ++r)
    each.emplace_back(all.begin() + offsets[r], all.begin() + offsets[r] + counts[r]);
  return each;
}

Words from_first_rank(const Words& own) {
  if (all_ranks == 1) return own;
  Words words = own;
  auto count = static_cast<Word>(own.size());
  const Talk talk(this_rank == 0 ? others() : 0, own.size() * sizeof(Word));
  MPI_Bcast(&count, 1, MPI_UINT64_T, 0, MPI_COMM_WORLD);
  words.resize(count);
  MPI_Bcast(words.data(), count_of(words), MPI_UINT64_T, 0, MPI_COMM_WORLD);
  return words;
}

#else

void begin_ranks() {
  if (started_by_launcher() && processes_started() > 1)
    throw InputError({{},
                      {},
                      {},
                      "several processes were started, but this program was built without MPI",
                      "one process with --threads; or a build where cmake finds MPI (libopenmpi-dev)"});
}
void leave_ranks(int) {}
void combine_over_ranks(void*, std::size_t, std::size_t, const Combine&) {}
std::vector<Words> exchange_words(const std::vector<Words>& to) { return to; }
void exchange_words(const std::vector<Words>& to, std::vector<Words>& from) { from = to; }
std::vector<Words> gather_on_all(const Words& own) { return {own}; }
Words from_first_rank(const Words& own) { return own; }

#endif

}  // namespace tektite
