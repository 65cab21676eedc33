#include "parallel/file_order.hpp"

#include <algorithm>
#include <tuple>
#include <utility>

#include "parallel/packed.hpp"

namespace tektite {
namespace {

/// By which particles stand in a file: body, sequence and id.
using Key = std::tuple<Word, std::int64_t, std::int64_t>;

struct Member {
  Key key;
  std::uint32_t index;
};

std::vector<Member> own_in_order(const Particles& particles) {
  const auto sequence = particles.integers(Field::sequence), id = particles.integers(Field::id);
  const Owned owned(particles);
  std::vector<Member> own;
  for (Word body = 0; body < particles.bodies().size(); ++body) {
    const auto& range = particles.bodies()[body].range;
    for (auto i = range.begin; i < range.end; ++i)
      if (owned(i)) own.push_back({{body, sequence[i], id[i]}, static_cast<std::uint32_t>(i)});
  }
  std::ranges::sort(own, {}, &Member::key);
  return own;
}

/// The first key of each rank's part but the first one's, by samples of all (Frazer and McKellar 1970, samplesort).
std::vector<Key> cuts_of(const std::vector<Member>& own, std::size_t count_of_all) {
  constexpr std::size_t samples_a_part = 64;
  const auto parts = static_cast<std::size_t>(ranks());
  const auto stride = std::max<std::size_t>(count_of_all / (samples_a_part * parts), 1);
  Words words;
  for (auto n = stride / 2; n < own.size(); n += stride) {
    const auto& [body, sequence, id] = own[n].key;
    words.insert(words.end(), {body, static_cast<Word>(sequence), static_cast<Word>(id)});
  }
  std::vector<Key> samples;
  for (const auto& of_rank : gather_on_all(words))
    for (auto word = of_rank.begin(); word != of_rank.end(); word += 3)
      samples.emplace_back(word[0], static_cast<std::int64_t>(word[1]), static_cast<std::int64_t>(word[2]));
  std::ranges::sort(samples);
  std::vector<Key> cuts;
  for (std::size_t part = 1; part < parts && !samples.empty(); ++part)
    cuts.push_back(samples[part * samples.size() / parts]);
  return cuts;
}

/// The rows of bodies in the file, of which `part` has some.
std::vector<Body> bodies_of_all(const std::vector<Body>& part) {
  Words own;
  for (const auto& body : part) own.push_back(body.range.size());
  std::vector<std::size_t> sizes(part.size(), 0);
  for (const auto& of_rank : gather_on_all(own))
    for (std::size_t k = 0; k < sizes.size(); ++k) sizes[k] += of_rank[k];
  return bodies_of_sizes(part, sizes);
}

}  // namespace

FileRows in_file_order(const Particles& particles) {
  const auto own = own_in_order(particles);
  const auto cuts = cuts_of(own, count_of_all(particles));
  const PackedLayout layout(particles);
  std::vector<Words> to(static_cast<std::size_t>(ranks()));
  for (std::size_t part = 0, n = 0; part < to.size(); ++part) {
    std::vector<std::uint32_t> members;
    for (; n < own.size() && (part >= cuts.size() || own[n].key < cuts[part]); ++n) members.push_back(own[n].index);
    layout.pack(particles, members, to[part]);
  }
  Words records;
  for (const auto& words : exchange_words(to)) records.insert(records.end(), words.begin(), words.end());
  auto rows = layout.build(particles, records);

  std::size_t first = 0;
  const auto counts = gather_on_all({rows.count()});
  for (int before = 0; before < rank(); ++before) first += counts[static_cast<std::size_t>(before)].front();
  const hdf5::Rows place(first, rows.count(), count_of_all(particles));
  auto bodies = bodies_of_all(rows.bodies());
  return {std::move(rows), std::move(bodies), place};
}

}  // namespace tektite
