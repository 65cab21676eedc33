// The page about runs: whole, well-formed, and nothing that it would have to fetch.

#include <vtkSmartPointer.h>
#include <vtkXMLDataElement.h>
#include <vtkXMLUtilities.h>

#include <algorithm>
#include <catch2/catch.hpp>
#include <filesystem>
#include <fstream>

#include "postprocess/page/html.hpp"
#include "postprocess/page/page.hpp"
#include "postprocess/page/plot.hpp"
#include "postprocess/pipeline.hpp"
#include "support/fault.hpp"
#include "support/program.hpp"
#include "support/temporary_folder.hpp"
#include "unit/postprocess/colours.hpp"
#include "unit/postprocess/synthetic.hpp"

namespace tektite::test {
namespace {

namespace fs = std::filesystem;
using Catch::Matchers::Contains;

const std::string trouble = "<b>\"3 > 2\" & 'so on'</b>";

/// A run that has been measured, with a title and a source that would break a careless page.
void write_run(const std::string& folder, double peak) {
  const auto space = Space::plane_strain;
  auto text = scene_text(space, false);
  text.replace(text.find("Disc through a plate"), 20, "Disc & plate <fast>");
  const auto particles = snapshot_of(space, impact(space, nullptr, false), 8e-6, text, as_it_is);
  fs::create_directories(folder + "/snapshots");
  fs::create_directories(folder + "/pictures");
  write_snapshot(particles, folder + "/snapshots/000000.h5");
  std::ofstream(folder + "/history.csv") << "step,time,kinetic_energy,centre.pressure\n0,0,4,0\n1,4e-6,3," << peak
                                         << "\n2,8e-6,2,-1e8\n";
  std::ofstream(folder + "/solve.json") << R"({"steps": 2, "scheme": "eulerian", "threads": 2, "cpu_seconds": 12.5,
    "energy_drift": 1e-4, "version": "0"})";
  std::ofstream(folder + "/reference.toml")
      << "[[reference]]\nmeasure = \"peak_pressure\"\npublished = \"2 GPa\"\nwithin_relative = 0.1\nsource = '''"
      << trouble << "'''\n";
  std::ofstream(folder + "/pictures/pressure.png", std::ios::binary) << "\x89PNG not really";
  PostprocessOptions options;
  options.run = folder;
  options.reference = folder + "/reference.toml";
  options.pictures = false;
  postprocess(options);
}

/// The tags of the page are all closed, in order, and its entities known.
bool is_well_formed(const std::string& page) {
  const auto root = vtkSmartPointer<vtkXMLDataElement>::Take(
      vtkXMLUtilities::ReadElementFromString(page.substr(page.find('\n') + 1).c_str()));
  return root && std::string(root->GetName()) == "html" && root->FindNestedElementWithName("body");
}

/// Red of a page's picture, 0 to 255: of its ground, and of the darkest and lightest that stands on it.
struct Shades {
  int darkest, ground, lightest;
};

Shades shades_of(const std::string& path) {
  const auto colours = colours_of(path);
  const auto most = std::ranges::max_element(colours, {}, [](const auto& entry) { return entry.second; });
  return {colours.begin()->first[0], most->first[0], colours.rbegin()->first[0]};
}

}  // namespace

TEST_CASE("Page: text is escaped, and base 64 is that of RFC 4648") {
  CHECK(escaped(trouble) == "&lt;b&gt;&quot;3 &gt; 2&quot; &amp; &#39;so on&#39;&lt;/b&gt;");
  CHECK(escaped(std::string("a\x01") + "b\n") == "a b\n");
  CHECK(base64("") == "");
  CHECK(base64("f") == "Zg==");
  CHECK(base64("fo") == "Zm8=");
  CHECK(base64("foo") == "Zm9v");
  CHECK(base64("foobar") == "Zm9vYmFy");
  CHECK(base64("\xff\xfe") == "//4=");
}

TEST_CASE("Page: a run with its cost, measures, history, picture and scene, well-formed and with no link") {
  const TemporaryFolder folder;
  write_run(folder.path(), 2.1e9);
  write_page({folder.path()}, folder.file("report.html"));
  const auto page = content_of(folder.file("report.html"));
  CHECK(is_well_formed(page));
  CHECK_FALSE(is_well_formed(page.substr(0, page.find("</table>")) + page.substr(page.find("</table>") + 8)));
  CHECK_THAT(page, Contains("<title>Disc &amp; plate &lt;fast&gt;</title>") && Contains(escaped(trouble)) &&
                       !Contains(trouble));
  CHECK_THAT(page, Contains("<td>12.5 s</td>") && Contains("2.1 GPa ± ") && Contains("(+5.0 %), within"));
  CHECK_THAT(page, Contains("<svg ") && Contains(">kinetic_energy</text>") && Contains(">centre.pressure</text>"));
  CHECK_THAT(page, Contains("src=\"data:image/png;base64,iVBORyBub3QgcmVhbGx5\""));
  CHECK_THAT(page, Contains("[measure.peak_pressure]") && !Contains("#@ "));
  CHECK_THAT(page, Contains("prefers-color-scheme: dark") && Contains("@media print"));
  for (const auto* fetched : {"http", "href", "url(", "<script", "@import"}) CHECK_THAT(page, !Contains(fetched));
}

TEST_CASE("Page: a peak of a single step in a long history is drawn") {
  Plot plot{"probes", "Pa", {}, {{"centre.pressure", std::vector<double>(10000, 0.0)}}, -5e8, 1e9, 9999.0};
  for (int k = 0; k < 10000; ++k) plot.times.push_back(k);
  plot.curves[0].values[5003] = 1e9;
  plot.curves[0].values[5005] = -5e8;
  const auto svg = svg_of(plot);
  const auto curve = svg.substr(svg.find("points="));
  CHECK_THAT(curve, Contains(",30.0 ") && Contains(",270.0 "));
  CHECK(std::ranges::count(curve, ',') < 2 * 640);
}

TEST_CASE("Page: several runs stand side by side, each with its own values") {
  const TemporaryFolder folder;
  write_run(folder.file("one"), 2.1e9);
  write_run(folder.file("two"), 3.0e9);
  fs::remove_all(folder.file("two/pictures"));
  const auto page = page_of({read_run_data(folder.file("one")), read_run_data(folder.file("two"))});
  CHECK(is_well_formed(page));
  CHECK_THAT(page, Contains("(+5.0 %), within</td><td>3 GPa ± ") && Contains("(+50.0 %), outside"));
  CHECK_THAT(page, Contains("and 1 more"));
  CHECK_THAT(page, Contains("<figure><figcaption>" + folder.file("two")));  // where it has no picture
}

TEST_CASE("Page: a folder that is no run, or has not been measured, is refused") {
  const TemporaryFolder folder;
  CHECK_THAT(fault_of([&] { read_run_data(folder.path()); }), Contains("holds no particles"));
  write_run(folder.path(), 2e9);
  fs::remove(folder.file("measurements.json"));
  CHECK_THAT(fault_of([&] { read_run_data(folder.path()); }), Contains("has not been measured"));
  const std::string length = R"("measurements": {"length": {"value": 1, "uncertainty": 0, "unit": "m"}}, )",
                    of_length = R"("references": [{"measure": "length", "unit": "m", "published": 1, "source": "us"}])";
  const auto write = [&](const std::string& json) { std::ofstream(folder.file("measurements.json")) << json; };
  const auto with = [](std::string json, const std::string& part, const std::string& other) {
    return json.replace(json.find(part), part.size(), other);
  };
  const auto whole = "{" + length + of_length + "}";
  write(whole);
  CHECK_NOTHROW(read_run_data(folder.path()));
  for (const auto& broken :
       {std::string("[1]"), with(whole, "\"value\": 1", "\"value\": null"), with(whole, "\"uncertainty\": 0, ", ""),
        with(whole, "\"published\": 1", "\"published\": \"1\""), with(whole, "\"us\"", "\"us\", \"within\": 1"),
        "{\"steps\": null, " + length + of_length + "}"}) {
    write(broken);
    INFO(broken);
    CHECK_THAT(fault_of([&] { read_run_data(folder.path()); }),
               Contains("measurements.json") && Contains("not what tektite-postprocess writes"));
  }
  CHECK_THROWS_WITH(data_uri(folder.file("gone.png"), "image/png"), folder.file("gone.png") + ": cannot be read");
}

TEST_CASE("Page: headless Chromium shows it, light or dark as is preferred, and prints it", "[.][browser]") {
  const TemporaryFolder folder;
  write_run(folder.path(), 2.1e9);
  write_page({folder.path()}, folder.file("report.html"));
  const auto chromium = [&](const std::vector<std::string>& options) {
    std::vector<std::string> words{"/usr/bin/chromium", "--headless=new", "--no-sandbox", "--disable-gpu",
                                   "--window-size=1000,1400"};
    words.insert(words.end(), options.begin(), options.end());
    words.push_back("file://" + folder.file("report.html"));
    const auto outcome = run_in(folder.path(), words);
    REQUIRE(outcome.code == 0);
    return outcome.output;
  };
  CHECK_THAT(chromium({"--dump-dom"}), Contains("<h2>") && Contains("2.1 GPa ± ") && Contains("</svg>"));
  chromium({"--screenshot=" + folder.file("light.png")});
  chromium({"--force-dark-mode", "--screenshot=" + folder.file("dark.png")});
  const auto light = shades_of(folder.file("light.png")), dark = shades_of(folder.file("dark.png"));
  CHECK(light.ground > 240);
  CHECK(light.darkest < 60);  // what is written
  CHECK(dark.ground < 60);
  CHECK(dark.lightest > 200);
  chromium({"--print-to-pdf=" + folder.file("report.pdf")});
  const auto printed = content_of(folder.file("report.pdf"));
  CHECK_THAT(printed, Catch::StartsWith("%PDF"));
  CHECK(printed.size() > 10000);
}

}  // namespace tektite::test
