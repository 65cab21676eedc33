// A scene as text: variants, settings, places, and the effective scene.
#include "core/document.hpp"

#include <catch2/catch.hpp>
#include <fstream>
#include <string>
#include <vector>

#include "support/fault.hpp"
#include "support/temporary_folder.hpp"

namespace tektite {
namespace {

using Catch::Matchers::Contains;
using test::fault_of;

constexpr const char* scene = R"(name = "bar"
time = { end = "8 us", cfl = 0.3 }

[material.steel]
density = "7.8 g/cm3"
eos = { model = "linear", sound_speed = "5 km/s" }

[variant.fine]
time.cfl = 0.1

[variant.other]
material.steel.eos = { model = "tait", exponent = 7 }
)";

class Fixture {
 public:
  explicit Fixture(const std::string& text = scene) { std::ofstream(path) << text; }
  Document load(const std::string& variant = {}, const std::vector<std::string>& settings = {}) const {
    return Document::load(path, variant, settings);
  }

 private:
  test::TemporaryFolder folder_;

 public:
  std::string path = folder_.file("scene.toml");
};

double cfl(Document document) {
  auto root = document.root();
  auto time = root.section("time");
  return time.quantity("cfl", dimension::none);
}

TEST_CASE("Document: tables within tables without end are refused, in a file and in a setting") {
  std::string key = "a";
  for (int k = 0; k < 100000; ++k) key += ".a";
  CHECK_THAT(fault_of([&] { Document::parse("x = 1\n[" + key + "]\n", "scene.toml"); }),
             Contains("scene.toml:2: not TOML: a key of too many parts (allowed: up to 32 parts"));
  const Fixture file;
  CHECK_THAT(fault_of([&] { file.load({}, {key + "=1"}); }), Contains("not a setting"));
}

TEST_CASE("Document: a variant overrides key by key and leaves the others") {
  const Fixture file;
  CHECK(cfl(file.load()) == 0.3);
  CHECK(cfl(file.load("fine")) == 0.1);
  auto document = file.load("fine");
  auto root = document.root();
  CHECK(root.section("time").quantity("end", dimension::time) == Approx(8e-6).epsilon(1e-15));
  CHECK(document.variants() == std::vector<std::string>{"fine", "other"});
}

TEST_CASE("Document: a table of another model replaces the scene's table whole") {
  auto document = Fixture().load("other");
  auto root = document.root();
  auto materials = root.section("material");
  auto steel = materials.section("steel");
  auto eos = steel.section("eos");
  CHECK(eos.text("model") == "tait");
  CHECK_FALSE(eos.has("sound_speed"));
  CHECK(steel.quantity("density", dimension::density) == Approx(7800.0).epsilon(1e-15));
}

TEST_CASE("Document: an unknown variant is answered with the known ones") {
  const Fixture file;
  const auto fault = fault_of([&] { file.load("coarse"); });
  CHECK_THAT(fault, Contains(file.path) && Contains("\"coarse\"") && Contains("allowed: fine, other"));
  const Fixture without("name = \"x\"\n");
  CHECK_THAT(fault_of([&] { without.load("coarse"); }), Contains("this scene has none"));
}

TEST_CASE("Document: what marks the comments of an effective scene may stand in a text of it") {
  const Fixture file("title = \"one #@ variant two\"\nabout = \"\"\"\n#@ variant three\n#@ line 7 title\n\"\"\"\n");
  const auto again = Document::parse(file.load().text(), "effective");
  CHECK(again.variant().empty());
  CHECK(again.text() == file.load().text());
}

TEST_CASE("Document: settings are laid over the variant, as TOML or as bare text") {
  const Fixture file;
  CHECK(cfl(file.load("fine", {"time.cfl=0.2"})) == 0.2);
  CHECK(cfl(file.load("", {"time = { cfl = 0.25 }"})) == 0.25);
  auto document = file.load("", {"time.end=9 us", "title=a bare text", "list=[1, 2]", "flag=true"});
  auto root = document.root();
  CHECK(root.section("time").quantity("end", dimension::time) == Approx(9e-6).epsilon(1e-15));
  CHECK(root.text("title") == "a bare text");
  CHECK(root.quantities("list", dimension::none, 2) == std::vector<double>{1.0, 2.0});
  CHECK(root.flag("flag", false));
}

TEST_CASE("Document: a setting that is none is refused with an example") {
  const Fixture file;
  const std::string setting = GENERATE(as<std::string>(), "", "time.cfl", "=3", "a b=3", "a.=3", "x=\"open");
  INFO(setting);
  CHECK_THAT(fault_of([&] { file.load("", {setting}); }),
             Contains("not a setting") && Contains("KEY=VALUE, such as scheme.courant=0.2"));
}

TEST_CASE("Document: a setting holds one value and cannot smuggle in a second") {
  const Fixture file;
  CHECK_THAT(fault_of([&] { file.load("", {"title=1\nname = \"y\""}); }), Contains("not a setting"));
}

TEST_CASE("Document: a fault names file and line of the key, wherever it was laid over") {
  const Fixture file;
  const auto fault = [&](const std::string& variant, const std::vector<std::string>& settings) {
    auto document = file.load(variant, settings);
    auto root = document.root();
    return fault_of([&] { root.section("time").quantity("cfl", dimension::none, {1.0, 2.0}); });
  };
  CHECK_THAT(fault("", {}), Contains(file.path + ":2: time.cfl = 0.3: out of range"));
  CHECK_THAT(fault("fine", {}), Contains(file.path + ":9: time.cfl = 0.1: out of range"));
  CHECK_THAT(fault("fine", {"time.cfl=0.2"}), Contains("--set time.cfl=0.2: time.cfl = 0.2: out of range"));
}

TEST_CASE("Document: tables come in the order in which they were laid over, here and in the next stage") {
  const Fixture file(R"([variant.wide.region.late]
x = 1
[variant.wide.region]
plain.x = 1
second.x = 5
[region.plain]
x = 0
[region.second]
x = 0
)");
  const auto order = [](Document document) {
    auto root = document.root();
    std::vector<std::string> names;
    for (const auto& [name, section] : root.named_sections("region")) names.push_back(name);
    return names;
  };
  using Names = std::vector<std::string>;
  CHECK(order(file.load()) == Names{"plain", "second"});
  CHECK(order(file.load("wide")) == Names{"plain", "second", "late"});
  auto document = file.load("wide", {"region.plain.y=3", "region.b={x=2}", "region.a={x=3}", "region.late.x=4"});
  CHECK(order(document) == Names{"plain", "second", "late", "b", "a"});
  CHECK(order(Document::parse(document.text(), "particles.h5")) == Names{"plain", "second", "late", "b", "a"});
}

TEST_CASE("Document: text that is no TOML is told with its line") {
  const Fixture file("name = \"x\"\nspace = \n");
  CHECK_THAT(fault_of([&] { file.load(); }), Contains(file.path + ":2: not TOML"));
  const Fixture twice("a = 1\nb = 2\na = 3\n");
  CHECK_THAT(fault_of([&] { twice.load(); }), Contains(":3: not TOML") && Contains("'a'"));
}

TEST_CASE("Document: a character outside of ASCII where TOML has none is told with its line") {
  const Fixture file("name = 'é'\n[body.kügelchen]\n");
  CHECK_THAT(fault_of([&] { file.load(); }),
             Contains(file.path + ":2: not TOML: a character outside of ASCII (allowed:"));
  CHECK_THAT(fault_of([&] { Fixture().load("", {"é=1"}); }), Contains("not a setting"));
  CHECK(Fixture().load("", {"title=é"}).root().text("title") == "é");
}

TEST_CASE("Document: a missing file and a folder are no scenes") {
  const test::TemporaryFolder folder;
  CHECK_THAT(fault_of([&] { Document::load(folder.file("none.toml"), "", {}); }), Contains("cannot be opened"));
  CHECK_THAT(fault_of([&] { Document::load(folder.path(), "", {}); }), Contains("cannot be read"));
}

TEST_CASE("Document: the effective scene reads back with values, defaults and places") {
  const Fixture file;
  auto document = file.load("fine");
  {
    auto root = document.root();
    auto time = root.section("time");
    time.quantity("end", dimension::time);
    time.quantity("start", dimension::time, {}, 1.5e-6);
  }
  auto again = Document::parse(document.text(), "particles.h5");
  CHECK(again.text() == document.text());
  CHECK(again.variant() == "fine");
  CHECK(file.load().variant().empty());
  auto root = again.root();
  auto time = root.section("time");
  CHECK(time.quantity("end", dimension::time) == Approx(8e-6).epsilon(1e-15));
  CHECK(time.quantity("start", dimension::time) == 1.5e-6);
  CHECK_THAT(time.fault("cfl", "wrong").what(), Contains(file.path + ":9: time.cfl"));
  CHECK_THAT(time.fault("start", "wrong").what(), Contains(file.path + ":2: time.start"));
  CHECK_THAT(fault_of([&] { root.section("probe"); }), Contains(file.path + ":1: probe: this key is missing"));
}

}  // namespace
}  // namespace tektite
