#pragma once
// Symmetry planes: every particle near a plane has an image behind it, made anew in each step from the particle's own
// record. A particle that lies on a plane has half its mass (the preprocessor gives it that) and an image in the same
// place, so that together they act as the whole one; it stays on the plane.

#include <cmath>
#include <cstdint>
#include <span>
#include <vector>

#include "core/particles.hpp"
#include "core/scene.hpp"
#include "core/tensor.hpp"

namespace tektite {

template <int D>
class Mirror {
 public:
  explicit Mirror(std::vector<SymmetryPlane> planes) : planes_(std::move(planes)) {}

  const std::vector<SymmetryPlane>& planes() const { return planes_; }
  std::size_t images() const { return images_.size(); }

  /// Finds who needs images: all within `reach` of a plane. Appends the images' places to `places`.
  void find(std::vector<Vector<double, D>>& places, double reach) {
    images_.clear();
    held_.assign(planes_.size(), {});
    const std::size_t count = places.size();
    for (std::size_t p = 0; p < planes_.size(); ++p) {
      const auto& plane = planes_[p];
      const std::size_t so_far = places.size();
      for (std::size_t i = 0; i < so_far; ++i) {
        const double distance = std::abs(places[i][plane.axis] - plane.at);
        if (distance >= reach) continue;
        if (i < count && distance <= on_plane * reach) held_[p].push_back(static_cast<std::uint32_t>(i));
        images_.push_back({static_cast<std::uint32_t>(i), static_cast<std::uint32_t>(p)});
        places.push_back(places[i]);
        reflect(places.back(), plane);
      }
    }
  }

  /// Appends to a value a particle those of the images, which have their particles' values.
  template <class T>
  void repeat(std::vector<T>& values) const {
    values.reserve(values.size() + images_.size());
    for (const auto& image : images_) values.push_back(values[image.source]);
  }

  /// Gives a place to each of the `count` particles and each image, and room to no more: with every search there may be
  /// some more images, and a vector that grows by a few makes twice the room.
  template <class Record>
  void fit(std::vector<Record>& records, std::size_t count) const {
    records.reserve(count + images_.size());
    records.resize(count + images_.size());
  }

  /// Fills the records of all images, which stand behind the `count` own ones. A record knows how to be mirrored.
  template <class Record>
  void fill(std::vector<Record>& records, std::size_t count) const {
    for (std::size_t k = 0; k < images_.size(); ++k) {
      records[count + k] = records[images_[k].source];
      records[count + k].mirror(planes_[images_[k].plane].axis, planes_[images_[k].plane].at);
    }
  }

  /// The particle that a record belongs to: itself, or the one that an image shows.
  std::size_t source_of(std::size_t record, std::size_t count) const {
    while (record >= count) record = images_[record - count].source;
    return record;
  }

  /// Takes the component across its plane from a vector of each particle that lies on one.
  void hold(Vector<double, D>* vectors) const {
    for (std::size_t p = 0; p < planes_.size(); ++p)
      for (const auto i : held_[p]) vectors[i][planes_[p].axis] = 0.0;
  }

 private:
  struct Image {
    std::uint32_t source;  ///< index of the record that it mirrors, which may be an image of an earlier plane
    std::uint32_t plane;
  };
  static constexpr double on_plane = 1e-6;  // of the reach: nearer than that is on the plane

  static void reflect(Vector<double, D>& x, const SymmetryPlane& plane) {
    x[plane.axis] = 2.0 * plane.at - x[plane.axis];
  }

  std::vector<SymmetryPlane> planes_;
  std::vector<Image> images_;
  std::vector<std::vector<std::uint32_t>> held_;
};

}  // namespace tektite
