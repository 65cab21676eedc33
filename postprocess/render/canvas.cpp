#include "postprocess/render/canvas.hpp"

#include <fmt/format.h>

#include <numbers>

#include "core/error.hpp"
#include "core/write_beside.hpp"

namespace tektite {
namespace {

void use(cairo_t* cairo, const Colour& colour) { cairo_set_source_rgb(cairo, colour[0], colour[1], colour[2]); }

}  // namespace

Canvas::Canvas(int width, int height)
    : width_(width),
      height_(height),
      surface_(cairo_image_surface_create(CAIRO_FORMAT_RGB24, width, height), cairo_surface_destroy),
      cairo_(cairo_create(surface_.get()), cairo_destroy) {
  if (const auto status = cairo_status(cairo_.get()); status != CAIRO_STATUS_SUCCESS)
    throw RunError(fmt::format("no picture of {} x {} pixels: {}", width, height, cairo_status_to_string(status)));
  use(cairo_.get(), {1.0, 1.0, 1.0});
  cairo_paint(cairo_.get());
  // Cairo counts rows from the highest down.
  cairo_translate(cairo_.get(), 0.0, height);
  cairo_scale(cairo_.get(), 1.0, -1.0);
  cairo_set_line_cap(cairo_.get(), CAIRO_LINE_CAP_ROUND);
  cairo_set_line_join(cairo_.get(), CAIRO_LINE_JOIN_ROUND);
}

void Canvas::clip(const Frame& part) {
  cairo_reset_clip(cairo_.get());
  cairo_rectangle(cairo_.get(), part.left, part.lower, part.width(), part.height());
  cairo_clip(cairo_.get());
}

void Canvas::rectangle(const Pixel& lower_left, const Pixel& upper_right, const Colour& colour) {
  use(cairo_.get(), colour);
  cairo_rectangle(cairo_.get(), lower_left.x, lower_left.y, upper_right.x - lower_left.x, upper_right.y - lower_left.y);
  cairo_fill(cairo_.get());
}

void Canvas::disc(const Pixel& centre, double radius, const Colour& colour) {
  use(cairo_.get(), colour);
  cairo_arc(cairo_.get(), centre.x, centre.y, radius, 0.0, 2.0 * std::numbers::pi);
  cairo_fill(cairo_.get());
}

void Canvas::lines(const std::vector<std::pair<Pixel, Pixel>>& segments, double width, const Colour& colour) {
  use(cairo_.get(), colour);
  cairo_set_line_width(cairo_.get(), width);
  const Pixel* end = nullptr;
  for (const auto& [from, to] : segments) {
    if (!end || end->x != from.x || end->y != from.y) cairo_move_to(cairo_.get(), from.x, from.y);
    cairo_line_to(cairo_.get(), to.x, to.y);
    end = &to;
  }
  cairo_stroke(cairo_.get());
}

void Canvas::lay(Image& image, int left, int lower) {
  const std::unique_ptr<cairo_surface_t, decltype(&cairo_surface_destroy)> surface(
      cairo_image_surface_create_for_data(reinterpret_cast<unsigned char*>(image.pixels()), CAIRO_FORMAT_ARGB32,
                                          image.width(), image.height(),
                                          cairo_format_stride_for_width(CAIRO_FORMAT_ARGB32, image.width())),
      cairo_surface_destroy);
  cairo_save(cairo_.get());
  cairo_identity_matrix(cairo_.get());
  cairo_set_source_surface(cairo_.get(), surface.get(), left, height_ - lower - image.height());
  cairo_paint(cairo_.get());
  cairo_restore(cairo_.get());
}

std::array<std::uint8_t, 3> Canvas::colour_of(int x, int y) const {
  cairo_surface_flush(surface_.get());
  const auto* row = cairo_image_surface_get_data(surface_.get()) +
                    static_cast<std::ptrdiff_t>(height_ - 1 - y) * cairo_image_surface_get_stride(surface_.get());
  const auto pixel = reinterpret_cast<const std::uint32_t*>(row)[x];
  return {static_cast<std::uint8_t>(pixel >> 16), static_cast<std::uint8_t>(pixel >> 8),
          static_cast<std::uint8_t>(pixel)};
}

void Canvas::write_png(const std::string& path) const {
  write_beside(path, [&](const std::string& beside) {
    const auto status = cairo_surface_write_to_png(surface_.get(), beside.c_str());
    if (status != CAIRO_STATUS_SUCCESS)
      throw RunError(fmt::format("{}: cannot be written: {}", path, cairo_status_to_string(status)));
  });
}

}  // namespace tektite
