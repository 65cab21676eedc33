#include "parallel/packed.hpp"

#include <algorithm>
#include <bit>
#include <numeric>

#include "parallel/for_each.hpp"

namespace tektite {
namespace {

std::size_t slot(Field field) { return static_cast<std::size_t>(field); }

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

std::vector<std::uint32_t> owned_in(const Particles& particles) {
  const Owned owned(particles);
  std::vector<std::uint32_t> own;
  for (std::uint32_t i = 0; i < particles.count(); ++i)
    if (owned(i)) own.push_back(i);
  return own;
}

std::vector<Word> body_of_each(const Particles& particles, std::span<const std::uint32_t> members) {
  const auto& bodies = particles.bodies();
  std::vector<Word> numbers(members.size());
  for_each(members.size(), [&](std::size_t n) {
    const auto body =
        std::ranges::upper_bound(bodies, std::size_t{members[n]}, {}, [](const Body& b) { return b.range.end; });
    numbers[n] = static_cast<Word>(body - bodies.begin());
  });
  return numbers;
}

std::vector<OrderKey> order_keys(const Particles& particles, std::span<const std::uint32_t> members) {
  const auto bodies = body_of_each(particles, members);
  const auto sequence = particles.integers(Field::sequence), id = particles.integers(Field::id);
  std::vector<OrderKey> keys(members.size());
  for_each(members.size(), [&](std::size_t n) { keys[n] = {bodies[n], sequence[members[n]], id[members[n]]}; });
  return keys;
}

PackedLayout::PackedLayout(const Particles& particles) {
  for (const auto& row : field_table)
    if (row.keep != Keep::scratch && particles.has(row.field)) add(particles, row.field);
}

void PackedLayout::add(const Particles& particles, Field field) {
  const auto components = static_cast<std::size_t>(particles.components(field));
  columns_.push_back({field, width_, components});
  offset_[slot(field)] = width_;
  width_ += components;
}

void PackedLayout::pack(const Particles& particles, std::span<const std::uint32_t> members, Words& words) const {
  const auto begin = words.size();
  words.resize(begin + members.size() * width_);
  const auto bodies = body_of_each(particles, members);
  for_each(members.size(), [&](std::size_t n) { words[begin + n * width_] = bodies[n]; });
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

/// `done` is told each field of the particles that is needed no more.
template <class Done>
Particles PackedLayout::joined(const Particles& particles, std::span<const std::uint32_t> members, const Words& words,
                               const Done& done) const {
  auto keys = order_keys(particles, members);
  const auto sequence = offset_[slot(Field::sequence)], id = offset_[slot(Field::id)];
  for (auto record = words.begin(); record != words.end(); record += static_cast<std::ptrdiff_t>(width_))
    keys.emplace_back(record[0], static_cast<std::int64_t>(record[static_cast<std::ptrdiff_t>(sequence)]),
                      static_cast<std::int64_t>(record[static_cast<std::ptrdiff_t>(id)]));
  std::vector<std::uint32_t> order(keys.size());
  std::iota(order.begin(), order.end(), 0U);
  std::ranges::sort(order, {}, [&](std::uint32_t n) { return keys[n]; });
  std::vector<std::size_t> sizes(particles.bodies().size(), 0);
  for (const auto& key : keys) ++sizes[std::get<0>(key)];
  keys = std::vector<OrderKey>();  // {} would keep its memory

  Particles all(particles.space(), bodies_of_sizes(particles.bodies(), sizes));
  for (const auto& column : columns_) {
    all.allocate(column.field);
    with_numbers(all, column.field, [&](const auto& numbers) {
      using Number = typename std::decay_t<decltype(numbers)>::value_type;
      const auto width = column.components;
      with_numbers(particles, column.field, [&](const auto& here) {
        for_each(order.size(), [&](std::size_t k) {
          const std::size_t n = order[k];
          for (std::size_t c = 0; c < width; ++c)
            numbers[k * width + c] =
                n < members.size() ? std::bit_cast<Number>(here[members[n] * width + c])
                                   : std::bit_cast<Number>(words[(n - members.size()) * width_ + column.offset + c]);
        });
      });
    });
    done(column.field);
  }
  return all;
}

Particles PackedLayout::joined(const Particles& particles, std::span<const std::uint32_t> members,
                               const Words& words) const {
  return joined(particles, members, words, [](Field) {});
}

void PackedLayout::join(Particles& particles, std::span<const std::uint32_t> members, const Words& words) const {
  for (const auto& row : field_table)
    if (offset_[slot(row.field)] == 0) particles.release(row.field);
  particles = joined(particles, members, words, [&](Field field) { particles.release(field); });
}

}  // namespace tektite
