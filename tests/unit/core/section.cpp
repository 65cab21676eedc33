// Reading one table of a scene: every kind of fault, with its place.
#include <catch2/catch.hpp>
#include <cmath>
#include <limits>
#include <string>
#include <vector>

#include "core/document.hpp"
#include "support/fault.hpp"

namespace tektite {
namespace {

using Catch::Matchers::Contains;
using Catch::Matchers::Equals;
using test::fault_of;

/// The message when `read` is applied to a scene of one line.
template <class Read>
std::string fault(const std::string& line, Read&& read) {
  auto document = Document::parse(line, "scene.toml");
  auto root = document.root();
  return fault_of([&] { read(root); });
}

const auto read_length = [](Section& root) { root.quantity("x", dimension::length, limits::positive); };
const std::vector<std::string> shapes{"disc", "ring"};

TEST_CASE("Section: a quantity is converted to SI and written back") {
  auto document = Document::parse("x = \"2 mm\"\ny = 3", "scene.toml");
  auto root = document.root();
  CHECK(root.quantity("x", dimension::length) == 2e-3);
  CHECK(root.quantity("y", dimension::speed) == 3.0);
  CHECK(root.quantity("z", dimension::time, limits::positive, 4.5) == 4.5);
  auto again = Document::parse(document.text(), "effective");
  auto effective = again.root();
  CHECK(effective.quantity("x", dimension::none) == 2e-3);
  CHECK(effective.quantity("z", dimension::none) == 4.5);
}

TEST_CASE("Section: a quantity that is wrong is told with place, key, value, reason and what is allowed") {
  CHECK_THAT(fault("\nx = \"2 s\"", read_length),
             Equals("scene.toml:2: x = \"2 s\": this is a time (s, ms, us) (allowed: a length (m, cm, mm, um))"));
  CHECK_THAT(fault("x = \"2 furlong\"", read_length), Contains("x = \"2 furlong\": not a number with a unit"));
  CHECK_THAT(fault("x = true", read_length), Contains("x = true: not a number"));
  CHECK_THAT(fault("x = [1.25, 0.1]", read_length), Contains("x = [1.25, 0.1]: not a number"));
  CHECK_THAT(fault("x = { y = 1 }", read_length),
             Contains("x: not a number") || Contains("x = { y = 1 }: not a number"));
  CHECK_THAT(fault("x = nan", read_length), Contains("x = nan: not a finite number"));
  CHECK_THAT(fault("x = -inf", read_length), Contains("x = -inf: not a finite number"));
  CHECK_THAT(fault("x = \"nan m\"", read_length), Contains("not a finite number"));
  CHECK_THAT(fault("x = -0.001", read_length), Equals("scene.toml:1: x = -0.001: out of range (allowed: > 0 m)"));
  CHECK_THAT(fault("x = \"0 m\"", read_length), Contains("out of range (allowed: > 0 m)"));
  CHECK_THAT(fault("y = 1", read_length), Contains("scene.toml:1: x: this key is missing"));
}

TEST_CASE("Section: control characters of a value and of a key neither cut a message short nor break its line") {
  CHECK_THAT(fault("x = \"a\\u0000b\\nc\\u001B[31m\"", read_length),
             Contains("x = \"a\\u0000b\\u000ac\\u001b[31m\": not a number with a unit"));
  CHECK_THAT(fault("\"a\\nb\\u007F\" = 1", [](Section& root) { root.finish(); }),
             Equals("scene.toml:1: a\\u000ab\\u007f: unknown key"));
}

TEST_CASE("Section: a plain number with a unit is refused, and so is a unit where none belongs") {
  const auto read_ratio = [](Section& root) { root.quantity("x", dimension::none); };
  CHECK_THAT(fault("x = \"2 mm\"", read_ratio), Contains("this is a length") && Contains("a plain number"));
  CHECK_THAT(fault("x = \"2\"", read_length), Contains("this is a plain number") && Contains("a length"));
}

TEST_CASE("Section: lists of quantities and of points are checked for their length and their elements") {
  const auto read_pair = [](Section& root) { root.quantities("x", dimension::length, 2); };
  CHECK_THAT(fault("x = 1", read_pair), Contains("must be a list of 2 values"));
  CHECK_THAT(fault("x = [1]", read_pair), Contains("x = [1]: must be a list of 2 values"));
  const auto read_direction = [](Section& root) { root.quantities("x", dimension::none, 2); };
  CHECK_THAT(fault("x = \"y\"", read_direction), Contains("must be a list of 2 values (allowed: each a plain number)"));
  CHECK_THAT(fault("x = [1, \"1 s\"]", read_pair), Contains("this is a time"));
  const auto read_points = [](Section& root) { root.points("x", {dimension::length, dimension::speed}, 3); };
  CHECK_THAT(fault("x = [[1, 2], [3, 4]]", read_points), Contains("a list of at least 3 points"));
  CHECK_THAT(fault("x = [[1, 2], [3, 4], [5]]", read_points), Contains("every point must have 2 coordinates"));
  CHECK_THAT(fault("x = [[1, 2], [3, 4], 5]", read_points), Contains("every point must have 2 coordinates"));
  CHECK_THAT(fault("x = [[1, 2], [3, 4], [5, \"6 m\"]]", read_points),
             Contains("this is a length") && Contains("speed"));
  auto document = Document::parse("x = [[\"1 mm\", 0], [1, \"2 km/s\"], [0, 1]]", "scene.toml");
  auto root = document.root();
  CHECK(root.points("x", {dimension::length, dimension::speed}, 3) ==
        std::vector<std::vector<double>>{{1e-3, 0.0}, {1.0, 2e3}, {0.0, 1.0}});
}

TEST_CASE("Section: whole numbers, switches and texts are not guessed from other types") {
  const auto read_count = [](Section& root) { root.integer("x", {1.0, 10.0}); };
  CHECK_THAT(fault("x = 2.0", read_count), Contains("x = 2.0: not a whole number"));
  CHECK_THAT(fault("x = \"2\"", read_count), Contains("not a whole number"));
  CHECK_THAT(fault("x = 11", read_count), Contains("x = 11: out of range (allowed: >= 1 and <= 10)"));
  CHECK_THAT(fault("x = 1", [](Section& root) { root.flag("x", false); }),
             Contains("not a switch (allowed: true, false)"));
  CHECK_THAT(fault("x = 1", [](Section& root) { root.text("x"); }), Contains("not a text"));
  CHECK_THAT(fault("x = \"\"", [](Section& root) { root.text("x"); }), Contains("not a text"));
  CHECK_THAT(fault("x = [\"a\", 1]", [](Section& root) { root.texts("x", {}); }), Contains("must be a list of texts"));
}

TEST_CASE("Section: an unknown name is answered with the known ones") {
  const auto read_shape = [](Section& root) { root.choice("x", shapes); };
  CHECK_THAT(fault("x = \"disk\"", read_shape), Contains("x = \"disk\": unknown name (allowed: disc, ring)"));
  CHECK_THAT(fault("x = 1", read_shape), Contains("not a name (allowed: disc, ring)"));
  CHECK_THAT(fault("y = 1", read_shape), Contains("x: this key is missing (allowed: disc, ring)"));
}

TEST_CASE("Section: tables and lists of tables are told apart from values") {
  CHECK_THAT(fault("x = 1", [](Section& root) { root.section("x"); }), Contains("x = 1: must be a table"));
  CHECK_THAT(fault("x = 1", [](Section& root) { root.named_sections("x"); }), Contains("[x.NAME]"));
  CHECK_THAT(fault("[x]\ny = 1", [](Section& root) { root.named_sections("x"); }),
             Contains("scene.toml:2: x.y = 1: must be a table"));
  CHECK_THAT(fault("x = []", [](Section& root) { root.list("x"); }), Contains("must be a list of tables"));
  CHECK_THAT(fault("x = [1]", [](Section& root) { root.list("x"); }), Contains("must be a list of tables"));
}

TEST_CASE("Section: an element of a list of tables is named with its number and line") {
  auto document = Document::parse("[[x]]\ny = 1\n[[x]]\ny = -1\n", "scene.toml");
  auto root = document.root();
  auto elements = root.list("x");
  REQUIRE(elements.size() == 2);
  CHECK(elements[0].quantity("y", dimension::none, limits::positive) == 1.0);
  CHECK_THAT(fault_of([&] { elements[1].quantity("y", dimension::none, limits::positive); }),
             Contains("scene.toml:4: x[1].y = -1: out of range"));
}

TEST_CASE("Section: named tables come in the order of the file") {
  auto document = Document::parse("[body.zebra]\na = 1\n[body.ant]\na = 2\n", "scene.toml");
  auto root = document.root();
  auto bodies = root.named_sections("body");
  REQUIRE(bodies.size() == 2);
  CHECK(bodies[0].first == "zebra");
  CHECK(bodies[1].first == "ant");
}

TEST_CASE("Section: a key that nobody read is unknown, and the nearest known one is offered") {
  auto document = Document::parse("density = 1\nspacng = 2\n", "scene.toml");
  auto root = document.root();
  root.quantity("density", dimension::none);
  root.quantity("spacing", dimension::length, {}, 1.0);
  CHECK_THAT(fault_of([&] { root.finish(); }), Contains("scene.toml:2: spacng: unknown key, did you mean spacing?") &&
                                                   Contains("allowed: density, spacing"));
}

TEST_CASE("Section: a key that may be left out is offered where a key is unknown") {
  auto document = Document::parse("raduis = 1\n", "scene.toml");
  auto root = document.root();
  CHECK_FALSE(root.has("radius"));
  CHECK_THAT(fault_of([&] { root.finish(); }), Contains("did you mean radius?") && Contains("allowed: radius"));
}

TEST_CASE("Section: keys left to another stage are not unknown") {
  auto document = Document::parse("eos = { model = \"x\" }\n", "scene.toml");
  auto root = document.root();
  constexpr std::string_view others[]{"eos"};
  root.leave(others);
  CHECK_NOTHROW(root.finish());
}

TEST_CASE("Section: a long value is shortened at a whole character") {
  std::string value;
  for (int k = 0; k < 60; ++k) value += "µµ";
  const auto message = fault("x = \"" + value + "\"", [](Section& root) { root.choice("x", shapes); });
  CHECK_THAT(message, Contains("µ…: unknown name"));
  CHECK(message.size() < 200);
}

TEST_CASE("Limits: described as they are checked") {
  CHECK(limits::positive.describe() == "> 0");
  CHECK(limits::fraction.describe() == ">= 0 and <= 1");
  CHECK(limits::any.describe() == "any finite number");
  CHECK((Limits{1.0, 2.0, false, true}).describe() == ">= 1 and < 2");
  CHECK_FALSE(limits::positive.hold(0.0));
  CHECK(limits::not_negative.hold(0.0));
  CHECK_FALSE((Limits{1.0, 2.0, false, true}).hold(2.0));
}

}  // namespace
}  // namespace tektite
