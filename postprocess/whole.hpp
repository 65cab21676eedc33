#pragma once
// A snapshot made whole: where the scene has symmetry planes, the particles are joined by their mirror images, so that
// measures and pictures see the bodies and not the half that was computed. Everything has three coordinates here;
// those that the space does not have are zero.

#include <cstdint>
#include <string>
#include <vector>

#include "core/scene.hpp"
#include "core/snapshot.hpp"
#include "core/tensor.hpp"

namespace tektite {

using Point = Vector<double, 3>;

struct Whole {
  int dimensions = 0;
  double time = 0.0;            ///< in s
  std::vector<Body> bodies;     ///< as in the snapshot; ranges are those of the computed particles
  std::uint8_t axis_image = 0;  ///< of a radial space: the bit of `image` that is the axis or centre

  // One entry a particle: of n computed ones, the image m of the k-th is the entry m n + k.
  std::vector<Point> position;           ///< in m
  std::vector<Point> velocity;           ///< in m/s
  std::vector<double> mass;              ///< in kg
  std::vector<double> smoothing_length;  ///< in m
  std::vector<std::int32_t> body;        ///< index into bodies
  std::vector<std::int64_t> id;          ///< of the computed particle
  std::vector<std::uint32_t> source;     ///< place of the computed particle in the snapshot
  std::vector<std::uint8_t> image;       ///< bit k: mirrored in planes[k]; 0 for a computed particle
  std::vector<std::uint8_t> severed;     ///< 1: a failed total-Lagrangian particle, which exchanges no force

  std::size_t count() const { return position.size(); }
  /// Index of the body of this name; throws RunError, naming what there is, where there is none.
  std::int32_t body_named(const std::string& name) const;
};

/// The snapshot with its images in all `planes` (and the images of those).
Whole make_whole(const Snapshot& snapshot, const std::vector<SymmetryPlane>& planes);

/// The fields that this takes, as far as they are there.
const FieldSet& fields_of_whole();

/// The same of a particle file that check_file() lets pass, read one field at a time.
Whole read_whole(const std::string& path, const std::vector<SymmetryPlane>& planes);

/// For every particle of `now`, its place in `initial`, found by id and image. Throws RunError where one is unknown
/// there.
std::vector<std::uint32_t> places_in(const Whole& initial, const Whole& now);

}  // namespace tektite
