#include "parallel/file_order.hpp"

#include <algorithm>
#include <bit>
#include <numeric>
#include <tuple>

#include "parallel/for_each.hpp"

namespace tektite {
namespace {

struct Member {
  OrderKey key;
  std::uint32_t index;
};

std::vector<Member> own_in_order(const Particles& particles) {
  const auto own = owned_in(particles);
  const auto keys = order_keys(particles, own);
  std::vector<Member> members(own.size());
  for (std::size_t n = 0; n < own.size(); ++n) members[n] = {keys[n], own[n]};
  std::ranges::sort(members, {}, &Member::key);
  return members;
}

constexpr std::size_t words_of_key = 3;

void append(const OrderKey& key, Words& words) {
  const auto& [body, sequence, id] = key;
  words.insert(words.end(), {body, static_cast<Word>(sequence), static_cast<Word>(id)});
}

std::vector<OrderKey> keys_in(const std::vector<Words>& of_ranks) {
  std::size_t count = 0;
  for (const auto& words : of_ranks) count += words.size() / words_of_key;
  std::vector<OrderKey> keys;
  keys.reserve(count);
  for (const auto& words : of_ranks)
    for (std::size_t word = 0; word < words.size(); word += words_of_key)
      keys.emplace_back(words[word], static_cast<std::int64_t>(words[word + 1]),
                        static_cast<std::int64_t>(words[word + 2]));
  return keys;
}

/// The first key of each rank's part but the first one's, by samples of all (Frazer and McKellar 1970, samplesort).
std::vector<OrderKey> cuts_of(const std::vector<Member>& own, std::size_t count_of_all) {
  constexpr std::size_t samples_a_part = 64;
  const auto parts = static_cast<std::size_t>(ranks());
  const auto stride = std::max<std::size_t>(count_of_all / (samples_a_part * parts), 1);
  Words words;
  for (auto n = stride / 2; n < own.size(); n += stride) append(own[n].key, words);
  auto samples = keys_in(gather_on_all(words));
  std::ranges::sort(samples);
  std::vector<OrderKey> cuts;
  for (std::size_t part = 1; part < parts && !samples.empty(); ++part)
    cuts.push_back(samples[part * samples.size() / parts]);
  return cuts;
}

/// The rows of bodies in the file, of which the ranks have as many as these keys tell.
std::vector<Body> bodies_of_all(const std::vector<Body>& bodies, const std::vector<OrderKey>& keys) {
  Words own(bodies.size(), 0);
  for (const auto& key : keys) ++own[std::get<0>(key)];
  std::vector<std::size_t> sizes(bodies.size(), 0);
  for (const auto& of_rank : gather_on_all(own))
    for (std::size_t k = 0; k < sizes.size(); ++k) sizes[k] += of_rank[k];
  return bodies_of_sizes(bodies, sizes);
}

/// Rows of so many, behind those of the ranks before.
hdf5::Rows rows_of_this_rank(std::size_t count, std::size_t count_of_all) {
  std::size_t first = 0;
  const auto counts = gather_on_all({count});
  for (int before = 0; before < rank(); ++before) first += counts[static_cast<std::size_t>(before)].front();
  return {first, count, count_of_all};
}

/// The places of keys once they are sorted.
std::vector<std::uint32_t> places(const std::vector<OrderKey>& keys) {
  std::vector<std::uint32_t> order(keys.size()), place(keys.size());
  std::iota(order.begin(), order.end(), 0U);
  std::ranges::sort(order, {}, [&](std::uint32_t n) { return keys[n]; });
  for (std::uint32_t k = 0; k < order.size(); ++k) place[order[k]] = k;
  return place;
}

}  // namespace

FileOrder::FileOrder(const Particles& particles)
    : particles_(particles), to_(static_cast<std::size_t>(ranks())), rows_(0) {
  const auto keys = bring_keys();
  place_ = places(keys);
  bodies_ = bodies_of_all(particles.bodies(), keys);
  rows_ = rows_of_this_rank(keys.size(), count_of_all(particles));
}

/// Finds who goes to which rank, and gives the keys of those that come here.
std::vector<OrderKey> FileOrder::bring_keys() {
  std::vector<Words> keys(to_.size());
  {
    const auto own = own_in_order(particles_);
    const auto cuts = cuts_of(own, count_of_all(particles_));
    for (std::size_t part = 0, n = 0; part < to_.size(); ++part)
      for (; n < own.size() && (part >= cuts.size() || own[n].key < cuts[part]); ++n) {
        to_[part].push_back(own[n].index);
        append(own[n].key, keys[part]);
      }
  }
  keys = exchange_words(keys);
  for (const auto& of_rank : keys) coming_.push_back(of_rank.size() / words_of_key);
  return keys_in(keys);
}

template <class Number>
std::span<const Number> FileOrder::bring(std::span<const Number> own, Field field, std::vector<Number>& rows) const {
  const auto width = static_cast<std::size_t>(particles_.components(field));
  std::vector<Words> to(to_.size()), from(to_.size());
  for (std::size_t r = 0; r < to.size(); ++r) {
    to[r].resize(to_[r].size() * width);
    from[r].resize(coming_[r] * width);
    for_each(to_[r].size(), [&](std::size_t n) {
      for (std::size_t c = 0; c < width; ++c) to[r][n * width + c] = std::bit_cast<Word>(own[to_[r][n] * width + c]);
    });
  }
  exchange_words(to, from);
  to = {};
  rows.resize(place_.size() * width);
  std::size_t before = 0;
  for (std::size_t r = 0; r < from.size(); before += coming_[r++])
    for_each(coming_[r], [&](std::size_t n) {
      for (std::size_t c = 0; c < width; ++c)
        rows[place_[before + n] * width + c] = std::bit_cast<Number>(from[r][n * width + c]);
    });
  return rows;
}

std::span<const double> FileOrder::reals(Field field) { return bring(particles_.reals(field), field, reals_); }

std::span<const std::int64_t> FileOrder::integers(Field field) {
  return bring(particles_.integers(field), field, integers_);
}

}  // namespace tektite
