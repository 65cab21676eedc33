#pragma once
// The particles of a run: one contiguous array a field, allocated only if somebody asked for it. Particles of a body
// lie together, so a body, and with it a material, is a range of indices.

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "core/fields.hpp"
#include "core/space.hpp"
#include "core/tensor.hpp"

namespace tektite {

struct Range {
  std::size_t begin = 0;
  std::size_t end = 0;
  std::size_t size() const { return end - begin; }
};

struct Body {
  std::string name;
  std::string material;
  double spacing = 0.0;  ///< δ in m
  Range range;
};

class Particles {
 public:
  Particles() = default;
  Particles(Space space, std::vector<Body> bodies);

  Space space() const { return space_; }
  int dimensions() const { return dimensions_of(space_); }
  std::size_t count() const { return count_; }
  const std::vector<Body>& bodies() const { return bodies_; }

  /// Allocates a field, zero-filled with room for `count() + spare` particles; keeps what is there.
  void allocate(Field field, std::size_t spare = 0);
  /// Takes the numbers of a field, one row a particle, for its own. Throws std::logic_error where they are not as many.
  void adopt(Field field, std::vector<double> values);
  void adopt(Field field, std::vector<std::int64_t> values);
  void release(Field field);
  bool has(Field field) const;
  int components(Field field) const { return components_of(info(field).rank, space_); }

  /// The numbers of an allocated field, particle after particle; with the spare places of the field.
  std::span<double> reals(Field field);
  std::span<const double> reals(Field field) const;
  std::span<std::int64_t> integers(Field field);
  std::span<const std::int64_t> integers(Field field) const;

  double* scalars(Field field) { return reals(field).data(); }
  const double* scalars(Field field) const { return reals(field).data(); }
  template <int D>
  Vector<double, D>* vectors(Field field) {
    return reinterpret_cast<Vector<double, D>*>(reals(field).data());
  }
  template <int D>
  const Vector<double, D>* vectors(Field field) const {
    return reinterpret_cast<const Vector<double, D>*>(reals(field).data());
  }
  template <int D>
  Symmetric<double, D>* symmetrics(Field field) {
    return reinterpret_cast<Symmetric<double, D>*>(reals(field).data());
  }
  template <int D>
  const Symmetric<double, D>* symmetrics(Field field) const {
    return reinterpret_cast<const Symmetric<double, D>*>(reals(field).data());
  }
  template <int D>
  Tensor<double, D>* tensors(Field field) {
    return reinterpret_cast<Tensor<double, D>*>(reals(field).data());
  }

  /// Brings particle order[k] to place k in every allocated field that is kept between steps.
  void permute(std::span<const std::uint32_t> order);

  /// Bytes of all allocated fields.
  std::size_t memory() const;

 private:
  Space space_ = Space::line;
  std::size_t count_ = 0;
  std::vector<Body> bodies_;
  std::array<bool, field_count> allocated_{};  ///< also of a rank that has no particles
  std::array<std::vector<double>, field_count> reals_;
  std::array<std::vector<std::int64_t>, field_count> integers_;
};

/// Bytes that one particle of this space takes in a field.
constexpr std::size_t bytes_of(Field field, Space space) {
  return sizeof(double) * static_cast<std::size_t>(components_of(info(field).rank, space));
}

}  // namespace tektite
