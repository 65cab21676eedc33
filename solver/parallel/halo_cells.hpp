#pragma once
// By which a rank tells the others where its particles are, without their places.

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <limits>
#include <span>
#include <unordered_set>
#include <vector>

#include "core/scene.hpp"
#include "parallel/halo.hpp"
#include "parallel/ranks.hpp"

namespace tektite {

/// A cell's number along each axis; zero along those that a space does not have.
using HaloCell = std::array<std::int64_t, 3>;

/// The least and the greatest number along each axis of some cells; of none to begin with.
class CellBox {
 public:
  CellBox() {
    least_.fill(std::numeric_limits<std::int64_t>::max());
    greatest_.fill(std::numeric_limits<std::int64_t>::min());
  }
  /// What words() gave.
  explicit CellBox(const Words& words) {
    for (std::size_t k = 0; k < 3; ++k) {
      least_[k] = std::bit_cast<std::int64_t>(words[k]);
      greatest_[k] = std::bit_cast<std::int64_t>(words[3 + k]);
    }
  }
  Words words() const {
    Words all;
    for (const auto& corner : {least_, greatest_})
      for (const auto number : corner) all.push_back(std::bit_cast<Word>(number));
    return all;
  }

  void take(const HaloCell& cell) {
    for (std::size_t k = 0; k < 3; ++k) {
      least_[k] = std::min(least_[k], cell[k]);
      greatest_[k] = std::max(greatest_[k], cell[k]);
    }
  }
  /// Whether a cell of one may touch or be a cell of the other.
  bool touches(const CellBox& other) const {
    for (std::size_t k = 0; k < 3; ++k)
      if (least_[k] - 1 > other.greatest_[k] || other.least_[k] - 1 > greatest_[k]) return false;
    return true;
  }

 private:
  HaloCell least_, greatest_;
};

/// Cells of a halo's width. In a key their numbers wrap around, so that each fits into a word: cells that fall together
/// by that only bring more copies. Space is folded along planes of symmetry, so that who is near to an image is near to
/// its particle, also beyond the plane.
class HaloCells {
 public:
  HaloCells(const Particles& particles, const Halo& halo, const std::vector<SymmetryPlane>& symmetry)
      : dimensions_(static_cast<std::size_t>(particles.dimensions())),
        // A little wider, so that no rounding parts particles that are nearer than the width by two cells.
        side_(halo.width * (1.0 + 1e-9)),
        places_(particles.reals(halo.places)),
        symmetry_(symmetry) {}

  HaloCell cell(std::size_t i) const {
    HaloCell cell{};
    for (std::size_t k = 0; k < dimensions_; ++k) {
      double place = places_[i * dimensions_ + k];
      for (const auto& plane : symmetry_)
        if (static_cast<std::size_t>(plane.axis) == k) place = std::abs(place - plane.at);
      cell[k] = static_cast<std::int64_t>(std::clamp(std::floor(place / side_), -farthest, farthest));
    }
    return cell;
  }
  Word key_of(const HaloCell& cell) const {
    Word key = 0;
    for (std::size_t k = 0; k < dimensions_; ++k) key |= (static_cast<Word>(cell[k]) & mask) << (bits * k);
    return key;
  }
  /// Whether one of those cells is this one or touches it.
  bool touches(Word key, const std::unordered_set<Word>& cells) const {
    std::size_t count = 1;
    for (std::size_t k = 0; k < dimensions_; ++k) count *= 3;
    for (std::size_t n = 0; n < count; ++n) {
      Word other = 0;
      for (std::size_t k = 0, rest = n; k < dimensions_; ++k, rest /= 3)
        other |= (((key >> (bits * k)) + rest % 3 - 1) & mask) << (bits * k);
      if (cells.contains(other)) return true;
    }
    return false;
  }

 private:
  static constexpr std::size_t bits = 21;
  static constexpr Word mask = (Word{1} << bits) - 1;
  static constexpr double farthest = 1e15;
  std::size_t dimensions_;
  double side_;
  std::span<const double> places_;
  const std::vector<SymmetryPlane>& symmetry_;
};

}  // namespace tektite
