#pragma once
// What part of space a picture shows, and from where.

#include <optional>
#include <vector>

#include "postprocess/measure/measure.hpp"
#include "postprocess/render/canvas.hpp"
#include "postprocess/render/picture.hpp"

namespace tektite {

struct Box {
  Point low{1e300, 1e300, 1e300};
  Point high{-1e300, -1e300, -1e300};

  void include(const Point& point) {
    for (int k = 0; k < 3; ++k) {
      low[k] = point[k] < low[k] ? point[k] : low[k];
      high[k] = point[k] > high[k] ? point[k] : high[k];
    }
  }
  Point centre() const { return 0.5 * (low + high); }
  double diagonal() const { return norm(high - low); }
};

/// The box of the picture's `view`, else of all fragments of the drawn particles that weigh at least a hundredth of
/// their body: far crumbs would make the bodies small. Segments of the measures are always inside.
Box framed(const Picture& picture, const Whole& whole, const std::vector<bool>& drawn,
           const std::vector<Segment>& segments);

/// How a solid scene is opened for a picture: a plane and the side of it that is kept; nullopt where it stays closed. A
/// cut takes away what is on the camera's side of it.
std::optional<SymmetryPlane> cut_of(const Picture& picture, const Scene& scene);

/// Where points of the scene are on a canvas. It looks along parallel lines, so that the scale bar and the lines of the
/// measures hold everywhere.
struct Camera {
  Point right, up, from;  ///< unit vectors; `from` points towards the camera
  Point centre;           ///< what is seen in the middle
  Pixel middle;
  double scale = 1.0;  ///< pixels a metre

  Pixel operator()(const Point& point) const {
    return {middle.x + scale * dot(point - centre, right), middle.y + scale * dot(point - centre, up)};
  }
  /// How near a point is to the camera, in pixels.
  double nearness(const Point& point) const { return scale * dot(point - centre, from); }
};

/// The camera in whose picture the box fills the frame: a plane scene face on, a solid one from the direction that the
/// picture names, or else obliquely, into the cut where there is one.
Camera aimed_camera(const Frame& frame, const Box& box, int dimensions, const Picture& picture,
                    const std::optional<SymmetryPlane>& cut);

}  // namespace tektite
