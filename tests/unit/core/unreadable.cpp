// Characters outside of ASCII in a TOML text: where they may stand.
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
    CHECK(first_unreadable(text) == std::string_view::npos);
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
    CHECK(first_unreadable(given) == (mark == std::string::npos ? 1 : mark));
  }
}

}  // namespace tektite
