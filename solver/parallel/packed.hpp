#pragma once
// Particles as messages: a record of words each, with its body and every field that is kept between steps.

#include <array>
#include <cstdint>
#include <span>
#include <tuple>
#include <vector>

#include "core/particles.hpp"
#include "parallel/ranks.hpp"

namespace tektite {

/// Bodies one behind the other, of so many particles each.
std::vector<Body> bodies_of_sizes(std::vector<Body> bodies, std::span<const std::size_t> sizes);
/// Which particles this rank owns.
std::vector<std::uint32_t> owned_in(const Particles& particles);
/// The number of the body of each.
std::vector<Word> body_of_each(const Particles& particles, std::span<const std::uint32_t> members);

/// By which particles stand in a single process and in a file: body, sequence and id.
using OrderKey = std::tuple<Word, std::int64_t, std::int64_t>;
std::vector<OrderKey> order_keys(const Particles& particles, std::span<const std::uint32_t> members);

class PackedLayout {
 public:
  /// Of particles with these fields.
  explicit PackedLayout(const Particles& particles);
  /// The same of one field alone.
  PackedLayout(const Particles& particles, Field field) { add(particles, field); }

  std::size_t width() const { return width_; }  ///< words of a record
  /// Appends the records of some particles.
  void pack(const Particles& particles, std::span<const std::uint32_t> members, Words& words) const;
  /// Takes over the fields of as many particles.
  void unpack(const Words& words, Particles& particles, std::span<const std::uint32_t> members) const;
  /// The `members` of particles and those of the records, by body, sequence and id: the order that a single process has
  /// them in.
  Particles joined(const Particles& particles, std::span<const std::uint32_t> members, const Words& words) const;
  /// Puts these in their place: a field after the other, so that memory has them once.
  void join(Particles& particles, std::span<const std::uint32_t> members, const Words& words) const;

 private:
  void add(const Particles& particles, Field field);
  template <class Done>
  Particles joined(const Particles& particles, std::span<const std::uint32_t> members, const Words& words,
                   const Done& done) const;

  struct Column {
    Field field;
    std::size_t offset, components;
  };
  std::vector<Column> columns_;
  std::array<std::size_t, field_count> offset_{};  ///< zero of a field that records do not have
  std::size_t width_ = 1;                          ///< the body stands first
};

}  // namespace tektite
