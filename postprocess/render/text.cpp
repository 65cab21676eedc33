#include "postprocess/render/text.hpp"

#include <vtkImageData.h>
#include <vtkSmartPointer.h>
#include <vtkStdString.h>
#include <vtkTextProperty.h>
#include <vtkTextRenderer.h>

#include <array>
#include <cmath>
#include <mutex>

#include "core/error.hpp"

namespace tektite {
namespace {

constexpr int dots_per_inch = 72;  // where a size of the font is one in pixels

vtkSmartPointer<vtkTextProperty> property_of(const TextStyle& style) {
  auto property = vtkSmartPointer<vtkTextProperty>::New();
  property->SetFontSize(static_cast<int>(style.size));
  property->SetColor(0.0, 0.0, 0.0);
  property->SetBackgroundColor(1.0, 1.0, 1.0);
  property->SetBackgroundOpacity(style.background);
  property->SetJustification(style.across == Across::left     ? VTK_TEXT_LEFT
                             : style.across == Across::centre ? VTK_TEXT_CENTERED
                                                              : VTK_TEXT_RIGHT);
  property->SetVerticalJustification(style.upwards == Upwards::bottom   ? VTK_TEXT_BOTTOM
                                     : style.upwards == Upwards::centre ? VTK_TEXT_CENTERED
                                                                        : VTK_TEXT_TOP);
  property->SetOrientation(style.turned ? 90.0 : 0.0);
  return property;
}

/// What VTK draws words with, which is one thread's at a time.
class Renderer {
 public:
  Renderer() : lock_(one_at_a_time), renderer_(vtkTextRenderer::GetInstance()) {
    if (renderer_ == nullptr) throw RunError("VTK has no font");
  }
  vtkTextRenderer* operator->() const { return renderer_; }

 private:
  static inline std::mutex one_at_a_time;
  std::scoped_lock<std::mutex> lock_;
  vtkTextRenderer* renderer_;
};

}  // namespace

void write(Canvas& canvas, const std::string& words, const Pixel& at, const TextStyle& style) {
  const Renderer renderer;
  const auto image = vtkSmartPointer<vtkImageData>::New();
  std::array<int, 2> size{};
  if (!renderer->RenderString(property_of(style), words, image, size.data(), dots_per_inch)) return;
  // The image's place is that of its lower left corner from the place of the words.
  const auto* extent = image->GetExtent();
  Image laid(size[0], size[1]);
  for (int y = 0; y < size[1]; ++y) {
    const auto* bytes = static_cast<const unsigned char*>(image->GetScalarPointer(extent[0], extent[2] + y, 0));
    for (int x = 0; x < size[0]; ++x, bytes += 4) {
      const auto part = [opacity = bytes[3]](unsigned char colour) {
        return static_cast<std::uint8_t>((colour * opacity + 127) / 255);
      };
      laid.set(x, y, {part(bytes[0]), part(bytes[1]), part(bytes[2]), bytes[3]});
    }
  }
  canvas.lay(laid, static_cast<int>(std::lround(at.x)) + extent[0], static_cast<int>(std::lround(at.y)) + extent[2]);
}

double width_of(const std::string& words, double size) {
  const Renderer renderer;
  std::array<int, 4> box{};
  TextStyle style;
  style.size = size;
  renderer->GetBoundingBox(property_of(style), words, box.data(), dots_per_inch);
  return box[1] - box[0] + 1;
}

}  // namespace tektite
