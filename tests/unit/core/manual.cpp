#include "core/manual.hpp"

#include <catch2/catch.hpp>

using namespace tektite;
using Catch::Matchers::Contains;
namespace po = boost::program_options;

namespace {

CommandLine line() {
  CommandLine line;
  line.usage = "tektite run SCENE.toml [-o DIR]\n       tektite run --check";
  line.about = ".5 of a sentence; a \\ in it";
  line.options.add_options()("output,o", po::value<std::string>()->value_name("DIR"), "where to")("no-pictures",
                                                                                                  "numbers only");
  line.hidden.add_options()("lock", po::value<int>());
  return line;
}

}  // namespace

TEST_CASE("Manual: a page is named by the words with which the usage begins") {
  CHECK(manual_of(line()).name == "tektite-run");
  CommandLine stage;
  stage.usage = "tektite-solve DIR [--resume]";
  CHECK(manual_of(stage).name == "tektite-solve");
}

TEST_CASE("Manual: every option that is not hidden stands there as it is typed") {
  const auto manual = manual_of(line());
  REQUIRE(manual.entries.size() == 2);
  CHECK(manual.entries[0].first == "-o, --output DIR");
  CHECK(manual.entries[0].second == "where to");
  CHECK(manual.entries[1].first == "--no-pictures");
  CHECK(option_words(line()) == "--output --no-pictures");
}

TEST_CASE("Manual: roff takes nothing of the text for a request or an escape") {
  const auto page = man_page(manual_of(line()));
  CHECK_THAT(page, Contains("\n\\&.5 of a sentence; a \\e in it\n"));
  CHECK_THAT(page, Contains("\\fB\\-o, \\-\\-output DIR\\fR\nwhere to\n"));
}

TEST_CASE("Manual: the name's line is the first sentence, in which names of files are whole") {
  CommandLine stage;
  stage.usage = "tektite-solve DIR";
  const auto name_line = [&](const std::string& about) {
    stage.about = about;
    const auto page = man_page(manual_of(stage));
    const auto from = page.find(".SH NAME\n") + 9;
    return page.substr(from, page.find('\n', from) - from);
  };
  CHECK(name_line("Computes DIR/particles.h5; leaves DIR/run.log.") == "tektite\\-solve \\- Computes DIR/particles.h5");
  CHECK(name_line("Computes a run. Leaves it.") == "tektite\\-solve \\- Computes a run");
  CHECK(name_line("Computes DIR/particles.h5\nand more") == "tektite\\-solve \\- Computes DIR/particles.h5");
  CHECK(name_line("Ends with one.") == "tektite\\-solve \\- Ends with one");
}
