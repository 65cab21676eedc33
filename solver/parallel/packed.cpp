#include "parallel/packed.hpp"

#include <algorithm>
#include <bit>
#include <numeric>
#include <tuple>

#include "parallel/for_each.hpp"

namespace tektite {
namespace {

Word word_of(double number) { return std::bit_cast<Word>(number); }
Word word_of(std::int64_t number) { return std::bit_cast<Word>(number); }

/// work(numbers) with those of a field, whatever they are.
template <class SomeParticles, class Work>
void with_numbers(SomeParticles& particles, Field field, const Work& work) {
  if (info(field).rank == Rank::integer)
    work(particles.integers(field));
  else
    work(particles.reals(field));
}

}  // namespace

std::vector<Body> bodies_of_sizes(std::vector<Body> bodies, std::span<const std::size_t> sizes) {
  std::size_t first = 0;
  for (std::size_t k = 0; k < bodies.size(); ++k) {
    bodies[k].range = {first, first + sizes[k]};
    first += sizes[k];
  }
  return bodies;
}

PackedLayout::PackedLayout(const Particles& particles) {
  for (const auto& row : field_table)
    if (row.keep != Keep::scratch && particles.has(row.field)) add(particles, row.field);
}

void PackedLayout::add(const Particles& particles, Field field) {
  const auto components = static_cast<std::size_t>(particles.components(field));
  columns_.push_back({field, width_, components});
  offset_[static_cast<std::size_t>(field)] = width_;
  width_ += components;
}

void PackedLayout::pack(const Particles& particles, std::span<const std::uint32_t> members, Words& words) const {
  const auto begin = words.size();
  words.resize(begin + members.size() * width_);
  const auto& bodies = particles.bodies();
  for_each(members.size(), [&](std::size_t n) {
    const auto body =
        std::ranges::upper_bound(bodies, std::size_t{members[n]}, {}, [](const Body& b) { return b.range.end; });
    words[begin + n * width_] = static_cast<Word>(body - bodies.begin());
  });
  for (const auto& column : columns_)
    with_numbers(particles, column.field, [&](const auto& numbers) {
      for_each(members.size(), [&](std::size_t n) {
        for (std::size_t c = 0; c < column.components; ++c)
          words[begin + n * width_ + column.offset + c] = word_of(numbers[members[n] * column.components + c]);
      });
    });
}

void PackedLayout::unpack(const Words& words, Particles& particles, std::span<const std::uint32_t> members) const {
  for (const auto& column : columns_)
    with_numbers(particles, column.field, [&](const auto& numbers) {
      using Number = typename std::decay_t<decltype(numbers)>::value_type;
      for_each(members.size(), [&](std::size_t n) {
        for (std::size_t c = 0; c < column.components; ++c)
          numbers[members[n] * column.components + c] = std::bit_cast<Number>(words[n * width_ + column.offset + c]);
      });
    });
}

Particles PackedLayout::build(const Particles& like, const Words& words) const {
  std::vector<std::uint32_t> order(words.size() / width_);
  std::iota(order.begin(), order.end(), 0U);
  const auto sequence = offset_of(Field::sequence), id = offset_of(Field::id);
  std::ranges::sort(order, {}, [&](std::uint32_t n) {
    const Word* record = words.data() + n * width_;
    return std::tuple(record[0], static_cast<std::int64_t>(record[sequence]), static_cast<std::int64_t>(record[id]));
  });
  std::vector<std::size_t> sizes(like.bodies().size(), 0);
  for (const auto n : order) ++sizes[words[n * width_]];
  Particles particles(like.space(), bodies_of_sizes(like.bodies(), sizes));
  std::vector<std::uint32_t> to(order.size());
  for (std::uint32_t k = 0; k < order.size(); ++k) to[order[k]] = k;
  for (const auto& column : columns_) particles.allocate(column.field);
  unpack(words, particles, to);
  return particles;
}

}  // namespace tektite
