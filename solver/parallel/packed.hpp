#pragma once
// Particles as messages: a record of words each, with its body and every field that is kept between steps.

#include <span>
#include <vector>

#include "core/particles.hpp"
#include "parallel/ranks.hpp"

namespace tektite {

/// Bodies one behind the other, of so many particles each.
std::vector<Body> bodies_of_sizes(std::vector<Body> bodies, std::span<const std::size_t> sizes);

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
  /// Particles of these records, by body, sequence and id: the order that a single process has them in.
  Particles build(const Particles& like, const Words& words) const;

  std::size_t offset_of(Field field) const { return offset_[static_cast<std::size_t>(field)]; }

 private:
  void add(const Particles& particles, Field field);

  struct Column {
    Field field;
    std::size_t offset, components;
  };
  std::vector<Column> columns_;
  std::array<std::size_t, field_count> offset_{};
  std::size_t width_ = 1;  ///< the body stands first
};

}  // namespace tektite
