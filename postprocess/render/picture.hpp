#pragma once
// What a scene asks to be drawn: [picture.NAME].

#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "core/document.hpp"
#include "postprocess/measure/measure.hpp"

namespace tektite {

enum class PictureType { particles, history, profile };

struct Region {
  std::vector<double> lower;  ///< in m
  std::vector<double> upper;
};

/// How a solid scene is opened: at its first symmetry plane if it has one; not at all; across an axis.
inline const std::vector<std::string> cut_names{"automatic", "none", "x", "y", "z"};

struct Picture {
  std::string name;  ///< names the file
  PictureType type = PictureType::particles;
  int width = 1600;  ///< in pixels
  int height = 1000;

  // particles and profiles
  std::string field;                               ///< a name of scalar_field_names()
  std::vector<std::string> bodies;                 ///< those that are drawn; all where it is empty
  std::optional<std::pair<double, double>> range;  ///< of the colours, in SI; that of the field where it is not given
  bool all_times = false;                          ///< every snapshot, not only the last one
  std::vector<double> times;                       ///< in s: the snapshots nearest to these
  std::optional<Region> view;                      ///< what is seen; everything coherent where it is not given
  std::string cut = "automatic";                   ///< in space: a name of cut_names
  double cut_at = 0.0;                             ///< in m: where the axis `cut` is cut
  std::optional<Point> from;                       ///< in space: the direction towards the camera
  bool measures = true;                            ///< whether the measures are drawn on it

  // history
  std::vector<std::string> columns;  ///< of history.csv

  // profile
  std::string along;             ///< x, y, z or radius
  Point centre = Point::zero();  ///< in m, of a radius

  /// Of history and profile: points of an exact curve, [abscissa, value] in SI.
  std::vector<std::vector<double>> exact;
};

/// Reads the tables [picture.NAME]; an unknown field or body is answered with the known ones.
std::vector<Picture> read_pictures(Section& root, const Declared& declared);

/// What is drawn where a scene asks for nothing: the fields of impact that the last snapshot holds, and over time the
/// energies and the pressures that probes saw.
std::vector<Picture> default_pictures(const FieldSet& held, const std::optional<History>& history);

/// The fields of a snapshot that a picture of it shows or needs.
FieldSet fields_shown(const Picture& picture);

}  // namespace tektite
