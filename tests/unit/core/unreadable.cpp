// Characters outside of ASCII in a TOML text, and how many parts a key has: what is kept from toml++.
#include "core/unreadable.hpp"

#include <catch2/catch.hpp>
#include <string>

namespace tektite {

TEST_CASE("Unreadable: characters outside of ASCII may stand in strings and comments") {
  for (const std::string text :
       {"", "a = 1", "# é", "# é\n# é", "a = 'é' # é", "a = \"é\\\"é\"", "a = 'é\\' # é", "a = '''é\né''é''''' # é",
        "a = \"\"\"é\\\"\"\"\" # é", "a = \"\"\"é\n\"é\"\"\"\"\"", "\xEF\xBB\xBF# é", "\"é\" = 1", "'é'.'ü' = 'µ'",
        "a = \"\"\"x\\\n  y é\"\"\"", "a = \"\" # é", "a = '' # é"}) {
    INFO(text);
    CHECK_FALSE(first_unreadable(text));
  }
}

TEST_CASE("Unreadable: the first one elsewhere is found") {
  for (const std::string text : {"@", "a = @é", "a = 1 @", "a = \"é\" @", "a = 'é\\' @", "[@]\na = 'é'", "a = \"x\n@\"",
                                 "a = \"\"\"é\"\"\"@", "a = \"\"\"é\"\"\"\"\"@", "a = '''é'''''@", "# é\n@",
                                 "a = \"\"\"x\\\n  @\"\"\"", "a = \"\"\"x\\@\"\"\"", "a\xEF\xBB\xBF"}) {
    auto given = text;
    const auto mark = given.find('@');
    if (mark != std::string::npos) given.replace(mark, 1, "é");
    INFO(given);
    const auto found = first_unreadable(given);
    REQUIRE(found);
    CHECK(found->at == (mark == std::string::npos ? 1 : mark));
    CHECK_THAT(found->what, Catch::Contains("outside of ASCII"));
  }
}

TEST_CASE("Unreadable: a key has at most 32 parts, each written in whatever way") {
  const auto key = [](int parts, const std::string& part, const std::string& dot) {
    auto text = part;
    for (int k = 1; k < parts; ++k) text.append(dot).append(part);
    return text;
  };
  for (const std::string part : {"a", "\"a.b\"", "'.'"})
    for (const std::string dot : {".", " . "}) {
      const auto most = key(32, part, dot), more = key(33, part, dot);
      for (const std::string before : {"", "[", "[[", "x = 1\n", "x = { a.b = 1, "}) {
        INFO(before << more);
        CHECK_FALSE(first_unreadable(before + most));
        const auto found = first_unreadable(before + more);
        REQUIRE(found);
        CHECK(found->at == (before + more).rfind('.', before.size() + more.size() - part.size() - 1));
        CHECK_THAT(found->what, Catch::Contains("too many parts"));
      }
    }
  std::string numbers = "x = [0.5", lines = "x = 0.5\n", words = "x = '";
  for (int k = 0; k < 100; ++k) {
    numbers += ", [0.5, 1.5], { y = 0.5 }";
    lines += "x.y = 0.5 # . . .\n";
    words += "...";
  }
  for (const auto& text : {numbers + "]", lines, words + "'"}) CHECK_FALSE(first_unreadable(text));
}

}  // namespace tektite
