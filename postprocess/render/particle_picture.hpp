#pragma once
// A field of the particles at one time, as a PNG file.

#include <vtkSmartPointer.h>

#include <string>

#include "postprocess/render/draw.hpp"

class vtkRenderWindow;

namespace tektite {

/// Draws all pictures of a run in one window: each new one would compile the same shaders again.
class ParticlePictures {
 public:
  ParticlePictures();

  /// Throws RunError where the snapshot does not hold the field or the file cannot be written.
  void draw(const Picture& picture, const Snapshot& snapshot, const Drawing& drawing, const std::string& path);

 private:
  vtkSmartPointer<vtkRenderWindow> window_;
};

}  // namespace tektite
