// What is painted covers what it should, and axes have round numbers.

#include "postprocess/render/canvas.hpp"

#include <catch2/catch.hpp>
#include <cmath>
#include <limits>

#include "postprocess/render/axis.hpp"
#include "postprocess/render/line_chart.hpp"
#include "postprocess/render/paint_particles.hpp"
#include "postprocess/render/places_apart.hpp"
#include "postprocess/render/text.hpp"
#include "support/temporary_folder.hpp"
#include "unit/postprocess/colours.hpp"

namespace tektite::test {
namespace {

constexpr tektite::Colour black{0.0, 0.0, 0.0};

/// How many pixels' worth of ink is on the canvas, where ink is black.
double ink(const Canvas& canvas) {
  double sum = 0.0;
  for (int y = 0; y < canvas.height(); ++y)
    for (int x = 0; x < canvas.width(); ++x) sum += (255.0 - canvas.colour_of(x, y)[0]) / 255.0;
  return sum;
}

/// Of one particle in the middle of a canvas of 40 by 40 pixels.
double ink_of_particle(int dimensions, double spacing) {
  Whole whole;
  whole.dimensions = dimensions;
  whole.bodies.resize(1);
  whole.bodies[0].spacing = spacing;
  whole.body = {0};
  whole.position = {Point::zero()};
  Camera camera;
  camera.right = {1.0, 0.0, 0.0};
  camera.up = {0.0, 1.0, 0.0};
  camera.from = {0.0, 0.0, 1.0};
  camera.centre = Point::zero();
  camera.middle = {20.0, 20.0};
  Canvas canvas(40, 40);
  paint_particles(canvas, canvas.all(), camera, whole, {true}, {black});
  return ink(canvas);
}

}  // namespace

TEST_CASE("Canvas: rectangles, discs and lines cover their area, wherever they lie between pixels") {
  for (const double shift : {0.0, 0.3, 0.5}) {
    Canvas rectangle(40, 40);
    rectangle.rectangle({10.0 + shift, 10.0 + shift}, {20.0 + shift, 15.0 + shift}, black);
    CHECK(ink(rectangle) == Approx(50.0).epsilon(0.01));
    Canvas disc(40, 40);
    disc.disc({20.0 + shift, 20.0}, 8.0, black);
    CHECK(ink(disc) == Approx(M_PI * 64.0).epsilon(0.01));
    Canvas line(40, 40);  // a line of 20 by 3 pixels with two half discs at its ends
    line.lines({{{10.0 + shift, 10.0}, {22.0 + shift, 26.0}}}, 3.0, black);
    CHECK(ink(line) == Approx(60.0 + M_PI * 2.25).epsilon(0.02));
  }
}

TEST_CASE("Canvas: a line in many pieces is the line in one") {
  Canvas one(40, 40), many(40, 40);
  one.lines({{{5.0, 5.0}, {35.0, 20.0}}}, 3.0, black);
  std::vector<std::pair<Pixel, Pixel>> pieces;
  for (int k = 0; k < 60; ++k) pieces.push_back({{5.0 + 0.5 * k, 5.0 + 0.25 * k}, {5.5 + 0.5 * k, 5.25 + 0.25 * k}});
  many.lines(pieces, 3.0, black);
  CHECK(ink(many) == Approx(ink(one)).epsilon(1e-3));
}

TEST_CASE("Canvas: nothing is painted outside of the part that is painted on") {
  Canvas canvas(40, 40);
  canvas.clip({10, 10, 20, 20});
  canvas.rectangle({-1e5, -1e5}, {1e5, 1e5}, black);
  canvas.lines({{{-1e5, 15.0}, {1e5, 15.0}}}, 3.0, black);
  CHECK(ink(canvas) == Approx(100.0));
}

TEST_CASE("Canvas: a particle is a disc of √½ of its spacing in the plane and a ball of half of it in space") {
  CHECK(ink_of_particle(2, 20.0) == Approx(M_PI * 200.0).epsilon(0.01));
  CHECK(ink_of_particle(3, 20.0) == Approx(M_PI * 100.0).epsilon(0.01));
}

TEST_CASE("Canvas: words stand where they are asked to and are as wide as is told") {
  const auto words_at = [](Across across) {
    Canvas canvas(200, 40);
    write(canvas, "HHHH", {100.0, 10.0}, {.size = 20.0, .across = across});
    int left = canvas.width(), right = 0;
    for (int y = 0; y < canvas.height(); ++y)
      for (int x = 0; x < canvas.width(); ++x)
        if (canvas.colour_of(x, y)[0] < 128) left = std::min(left, x), right = std::max(right, x);
    return std::pair{left, right};
  };
  const auto near = [](double place) { return Approx(place).margin(4.0); };
  const double width = width_of("HHHH", 20.0);
  CHECK(width > 40.0);
  CHECK(words_at(Across::left).first == near(100.0));
  CHECK(words_at(Across::left).second == near(100.0 + width));
  CHECK(words_at(Across::centre).first == near(100.0 - 0.5 * width));
  CHECK(words_at(Across::right).second == near(100.0));
}

TEST_CASE("Canvas: the PNG file has the pixels of the canvas") {
  const TemporaryFolder folder;
  Canvas canvas(30, 20);
  canvas.rectangle({3.0, 4.0}, {8.0, 6.0}, {0.2, 0.4, 0.6});
  canvas.write_png(folder.file("canvas.png"));
  CHECK(colours_of(folder.file("canvas.png")) == std::map<Colour, int>{{{255, 255, 255}, 590}, {{51, 102, 153}, 10}});
  CHECK(colours_of(folder.file("canvas.png"), {3, 4, 8, 6}) == std::map<Colour, int>{{{51, 102, 153}, 10}});
}

TEST_CASE("Axis: ticks are round numbers around all that is drawn") {
  const auto check = [](double least, double largest, int most_steps, const Axis& expected) {
    const auto axis = axis_of(least, largest, most_steps);
    CAPTURE(least, largest, most_steps);
    CHECK(axis.least == Approx(expected.least).margin(1e-12));
    CHECK(axis.step == Approx(expected.step));
    CHECK(axis.steps == expected.steps);
  };
  check(0.0, 8.06, 14, {0.0, 1.0, 9});
  check(-0.3, 0.3, 5, {-0.4, 0.2, 4});
  check(0.0, 0.3, 10, {0.0, 0.05, 6});
  check(5.0, 5.0, 5, {2.0, 2.0, 3});
  check(0.0, 0.0, 4, {-1.0, 0.5, 4});
  CHECK(without_round_off(0.3 - 3 * 0.1, 0.1) == 0.0);
  CHECK(without_round_off(0.1, 0.1) == 0.1);
}

TEST_CASE("Line chart: numbers that are not finite are left out") {
  const TemporaryFolder folder;
  constexpr double nan = std::numeric_limits<double>::quiet_NaN(), inf = std::numeric_limits<double>::infinity();
  const auto draw = [&](const std::string& name, const ChartLine& line) {
    draw_line_chart({"title", "x", "y", {line}, 400, 300}, folder.file(name));
    return colours_of(folder.file(name))[{230, 158, 0}];
  };
  const int whole = draw("whole.png", {"line", {0, 1, 2, 3, 4}, {0, 1, 2, 3, 4}});
  const int broken = draw("broken.png", {"line", {0, 1, 2, 3, 4}, {0, 1, nan, 3, 4}});
  CHECK(broken > 0.3 * whole);
  CHECK(broken < 0.8 * whole);
  CHECK(draw("none.png", {"line", {0, inf}, {nan, 1}}) < broken);
}

}  // namespace tektite::test

TEST_CASE("Labels of measures: none covers another, and those that cover none stay") {
  const std::vector<tektite::PictureBox> boxes{
      {0, 0, 10, 2}, {20, 0, 30, 2}, {5, 1, 25, 3}, {5, 1, 8, 3}, {0, 2, 10, 4}};
  const auto places = tektite::places_apart(boxes);
  const auto is = [&](std::size_t k, const tektite::PictureBox& box) {
    const auto& place = places.at(k);
    return place.left == box.left && place.lower == box.lower && place.right == box.right && place.upper == box.upper;
  };
  CHECK(is(0, boxes[0]));
  CHECK(is(1, boxes[1]));
  CHECK(is(2, {5, -2, 25, 0}));  // below the first two
  CHECK(is(3, {5, -4, 8, -2}));  // below the first, and then below the third
  CHECK(is(4, boxes[4]));        // on top of the first
}
