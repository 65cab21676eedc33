#pragma once
// The processes that compute one run together, each a part of its particles. A launcher of MPI starts them; without one
// there is a single process, and nothing here does anything.

#include <cstddef>
#include <cstdint>
#include <functional>
#include <vector>

#include "core/particles.hpp"

namespace tektite {

/// What is sent: numbers and identities, bit for bit.
using Word = std::uint64_t;
using Words = std::vector<Word>;

/// Joins the other processes, if a launcher has started several. Throws InputError where this program cannot.
void begin_ranks();
/// All has been done, or laid down in order, and every rank is about to leave.
void dismiss_ranks();
/// What another rank than the first one does that has come to the same fault: the first one tells it and ends all, and
/// this one waits for that so long that it need not come back.
void wait_to_be_ended();
/// The last thing that a process does. Where it has failed with this code before ranks were dismissed, the others would
/// wait for it for ever, and are ended too.
void leave_ranks(int code);

/// Which of the processes this one is; the first reads, writes and speaks.
int rank();
int ranks();

/// Whether these are a part of a run's particles: those that this rank owns, and copies of others that are near.
inline bool distributed(const Particles& particles) { return particles.has(Field::owner); }
/// How many all ranks own.
std::size_t count_of_all(const Particles& particles);
void note_count_of_all(std::size_t count);

/// Whether a particle counts here where each counts once.
class Owned {
 public:
  Owned() = default;  ///< all
  explicit Owned(const Particles& particles)
      : owner_(distributed(particles) ? particles.integers(Field::owner).data() : nullptr), rank_(rank()) {}
  bool operator()(std::size_t i) const { return !owner_ || owner_[i] == rank_; }

 private:
  const std::int64_t* owner_ = nullptr;
  std::int64_t rank_ = 0;
};

/// combine(part, whole, count) joins `count` values of another rank to those here: whole = whole and part. To be the
/// same in any order.
using Combine = std::function<void(const void* part, void* whole, std::size_t count)>;
/// Joins what is true of any.
inline constexpr auto either = [](bool& whole, bool part) { whole = whole || part; };

/// Gives every rank the values of all, joined; `size` is that of one in bytes.
void combine_over_ranks(void* values, std::size_t count, std::size_t size, const Combine& combine);

/// The value of all ranks by join(whole, part).
template <class Value, class Join>
Value of_all_ranks(Value value, const Join& join) {
  combine_over_ranks(&value, 1, sizeof(Value), [&](const void* part, void* whole, std::size_t) {
    join(*static_cast<Value*>(whole), *static_cast<const Value*>(part));
  });
  return value;
}

/// The same where the particles are distributed.
template <class Value, class Join>
Value over_ranks(const Particles& particles, Value value, const Join& join) {
  return distributed(particles) ? of_all_ranks(value, join) : value;
}

/// The same for each of some values.
template <class Value, class Join>
void each_over_ranks(const Particles& particles, std::vector<Value>& values, const Join& join) {
  if (!distributed(particles)) return;
  combine_over_ranks(values.data(), values.size(), sizeof(Value),
                     [&](const void* part, void* whole, std::size_t count) {
                       for (std::size_t k = 0; k < count; ++k)
                         join(static_cast<Value*>(whole)[k], static_cast<const Value*>(part)[k]);
                     });
}

/// Sends to[r] to each rank r, and gives what each has sent here.
std::vector<Words> exchange_words(const std::vector<Words>& to);
/// The same where it is known how much comes: from[r] is as long.
void exchange_words(const std::vector<Words>& to, std::vector<Words>& from);
/// What every rank has, on every rank.
std::vector<Words> gather_on_all(const Words& own);
/// What the first rank has, on every rank.
Words from_first_rank(const Words& own);

}  // namespace tektite
