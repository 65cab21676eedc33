#include "parallel/distribution.hpp"

#include <algorithm>
#include <bit>
#include <numeric>
#include <unordered_map>
#include <unordered_set>
#include <utility>

#include "parallel/halo_cells.hpp"
#include "parallel/partition.hpp"

namespace tektite {
namespace {

std::size_t slot(int number) { return static_cast<std::size_t>(number); }

/// A number of each rank.
std::vector<double> numbers_of_all(double own) {
  std::vector<double> numbers;
  for (const auto& words : gather_on_all({std::bit_cast<Word>(own)}))
    numbers.push_back(std::bit_cast<double>(words.front()));
  return numbers;
}

std::vector<Words> for_each_rank() { return std::vector<Words>(slot(ranks())); }

Words joined(std::vector<Words> all) {
  Words words;
  for (auto& one : all) {
    words.insert(words.end(), one.begin(), one.end());
    one = Words();  // {} would keep its memory
  }
  return words;
}

}  // namespace

std::pair<std::size_t, std::size_t> least_and_most_owned(const Particles& particles) {
  const auto counts = gather_on_all({owned_in(particles).size()});
  const auto [least, most] = std::ranges::minmax(counts, {}, [](const Words& words) { return words.front(); });
  return {least.front(), most.front()};
}

void Distribution::deal(Particles& particles, const Halos& halos) {
  if (!dealt_ || worth_it(particles)) move(particles, halos.front().places);
  seconds_ = 0.0;
  steps_ = 0;
  fetch_copies(particles, halos);
}

/// Whether the ranks have lost more, since their particles were dealt, than to deal them again takes: by waiting for
/// the slowest, and by having to compute more copies. Both are measured against the mean of the first steps after that.
bool Distribution::worth_it(const Particles& particles) {
  if (steps_ == 0) return false;
  const auto steps = static_cast<double>(steps_);
  const auto seconds = numbers_of_all(seconds_ / steps);
  const double mean = std::accumulate(seconds.begin(), seconds.end(), 0.0) / static_cast<double>(seconds.size());
  if (fresh_step_ == 0.0) fresh_step_ = mean;
  lost_ += steps * (std::ranges::max(seconds) - fresh_step_);
  cost_ = seconds_ / steps / std::max(static_cast<double>(owned_in(particles).size()), 1.0);
  return lost_ > moving_;
}

/// The rank that gets each of the own particles.
std::vector<int> Distribution::new_owners(const Particles& particles, Field places,
                                          const std::vector<std::uint32_t>& own) const {
  const auto dimensions = static_cast<std::size_t>(particles.dimensions());
  std::vector<PartitionPoint> points;
  for (const auto i : own) {
    auto& point = points.emplace_back(PartitionPoint{{}, cost_});
    for (std::size_t k = 0; k < dimensions; ++k) point.x[k] = particles.reals(places)[i * dimensions + k];
  }
  return ranks_of(points);
}

/// Brings the particles to new owners.
void Distribution::move(Particles& particles, Field places) {
  const auto start = Clock::now();
  const auto own = owned_in(particles);
  const auto owners = new_owners(particles, places, own);
  for (std::size_t n = 0; n < own.size(); ++n) particles.integers(Field::owner)[own[n]] = owners[n];
  std::vector<std::vector<std::uint32_t>> members(slot(ranks()));
  for (std::size_t n = 0; n < own.size(); ++n) members[slot(owners[n])].push_back(own[n]);
  const PackedLayout layout(particles);
  auto to = for_each_rank();
  for (std::size_t r = 0; r < to.size(); ++r)
    if (r != slot(rank())) layout.pack(particles, members[r], to[r]);
  auto from = exchange_words(to);
  to = {};
  layout.join(particles, members[slot(rank())], joined(std::move(from)));
  const auto seconds = numbers_of_all(std::chrono::duration<double>(Clock::now() - start).count());
  moving_ = std::ranges::max(seconds);
  fresh_step_ = lost_ = 0.0;
  dealt_ = true;
}

namespace {

/// The box about each rank's own particles.
std::vector<CellBox> boxes_of_all(const HaloCells& cells, const Particles& particles) {
  const Owned owned(particles);
  CellBox own;
  for (std::size_t i = 0; i < particles.count(); ++i)
    if (owned(i)) own.take(cells.cell(i));
  std::vector<CellBox> boxes;
  for (const auto& words : gather_on_all(own.words())) boxes.emplace_back(words);
  return boxes;
}

/// The cells of each rank that may touch one of this rank's own, of its own particles or of all that it has.
std::vector<std::unordered_set<Word>> keys_of_others(const HaloCells& cells, const Particles& particles,
                                                     const Owned& counts) {
  const auto boxes = boxes_of_all(cells, particles);
  std::unordered_map<Word, CellBox> inhabited;
  for (std::size_t i = 0; i < particles.count(); ++i)
    if (counts(i)) {
      const auto cell = cells.cell(i);
      inhabited[cells.key_of(cell)].take(cell);
    }
  auto to = for_each_rank();
  for (std::size_t r = 0; r < to.size(); ++r)
    if (r != slot(rank()))
      for (const auto& [key, box] : inhabited)
        if (box.touches(boxes[r])) to[r].push_back(key);
  std::vector<std::unordered_set<Word>> keys;
  for (const auto& words : exchange_words(to)) keys.emplace_back(words.begin(), words.end());
  return keys;
}

/// Adds copies of all that are in a halo and not there yet.
void add_copies(Particles& particles, const Halo& halo, const std::vector<SymmetryPlane>& symmetry,
                std::vector<std::vector<std::uint8_t>>& sent) {
  const HaloCells cells(particles, halo, symmetry);
  const auto theirs = keys_of_others(cells, particles, halo.of_copies ? Owned() : Owned(particles));
  const auto own = owned_in(particles);
  std::unordered_map<Word, std::vector<std::uint32_t>> members;  // numbers in `own`
  for (std::uint32_t n = 0; n < own.size(); ++n) members[cells.key_of(cells.cell(own[n]))].push_back(n);

  const PackedLayout layout(particles);
  auto to = for_each_rank();
  for (int r = 0; r < ranks(); ++r) {
    if (theirs[slot(r)].empty()) continue;
    std::vector<std::uint32_t> copied;
    for (const auto& [key, inside] : members) {
      if (!cells.touches(key, theirs[slot(r)])) continue;
      for (const auto n : inside)
        if (!std::exchange(sent[slot(r)][n], 1)) copied.push_back(own[n]);
    }
    layout.pack(particles, copied, to[slot(r)]);
  }
  auto from = exchange_words(to);
  to = {};
  std::vector<std::uint32_t> all(particles.count());
  std::iota(all.begin(), all.end(), 0U);
  layout.join(particles, all, joined(std::move(from)));
}

}  // namespace

Distribution::Sent Distribution::add_copies_to(Particles& own, const Halos& halos) const {
  Sent sent(slot(ranks()), std::vector<std::uint8_t>(own.count(), 0));
  for (const auto& halo : halos) add_copies(own, halo, symmetry_, sent);
  return sent;
}

Particles Distribution::with_copies(const Particles& particles, const Halos& halos) const {
  auto all = PackedLayout(particles).joined(particles, owned_in(particles), {});
  add_copies_to(all, halos);
  return all;
}

/// The own particles, and copies of all others in the halos.
void Distribution::fetch_copies(Particles& particles, const Halos& halos) {
  PackedLayout(particles).join(particles, owned_in(particles), {});
  const auto sent = add_copies_to(particles, halos);

  // Both sides have what goes from one to the other in the order of memory, which is the same for both.
  to_.assign(sent.size(), {});
  from_.assign(sent.size(), {});
  const auto own = owned_in(particles);
  for (std::size_t r = 0; r < sent.size(); ++r)
    for (std::size_t n = 0; n < own.size(); ++n)
      if (sent[r][n] != 0) to_[r].push_back(own[n]);
  const auto owner = particles.integers(Field::owner);
  for (std::uint32_t i = 0; i < particles.count(); ++i)
    if (owner[i] != rank()) from_[slot(static_cast<int>(owner[i]))].push_back(i);
}

void Distribution::refresh(Particles& particles) { refresh(particles, PackedLayout(particles)); }

void Distribution::refresh(Particles& particles, Field field) { refresh(particles, PackedLayout(particles, field)); }

void Distribution::refresh(Particles& particles, const PackedLayout& layout) {
  auto to = for_each_rank(), from = for_each_rank();
  for (std::size_t r = 0; r < to.size(); ++r) {
    layout.pack(particles, to_[r], to[r]);
    from[r].resize(from_[r].size() * layout.width());
  }
  exchange_words(to, from);
  for (std::size_t r = 0; r < from.size(); ++r) layout.unpack(from[r], particles, from_[r]);
}

}  // namespace tektite
