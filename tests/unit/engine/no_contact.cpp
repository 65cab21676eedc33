// A run whose bodies never meet says so.
#include "run/no_contact.hpp"

#include <catch2/catch.hpp>

#include "support/lattice.hpp"

using namespace tektite;

namespace {

/// Two bars of 10 mm on a line, the left one at 1 km/s, with this gap between them; after 2 µs.
std::optional<Warning> warning_of(double gap, const std::string& scheme) {
  constexpr double spacing = 1e-3;
  auto bars = test::particles_on(
      Space::line,
      {{"left", "metal", spacing, {-9.5e-3 - gap}, {10}, {1000.0}}, {"right", "metal", spacing, {0.5e-3}, {10}, {0.0}}},
      2785.0);
  auto run = test::simulation_of(scheme +
                                     "time.end = '2 us'\n[material.metal]\ndensity = 2785.0\n"
                                     "eos = { model = 'linear', bulk_modulus = '79 GPa' }\n",
                                 std::move(bars));
  test::run_to_the_end(run);
  return no_contact(run);
}

}  // namespace

TEST_CASE("No contact: bodies that have not met by the end are told of, and no others", "[run]") {
  const std::string eulerian = "scheme.type = 'eulerian'\n", lagrangian = "scheme.type = 'total-lagrangian'\n",
                    contact = "contact.model = 'kernel-penalty'\n";
  for (const auto& scheme : {eulerian, eulerian + contact, lagrangian + contact}) {
    INFO(scheme);
    const auto warning = warning_of(20e-3, scheme);  // of which 2 mm are flown
    REQUIRE(warning);
    CHECK(warning->name == "no-contact");
    CHECK_THAT(warning->text, Catch::Contains("no two of the 2 bodies"));
    CHECK_FALSE(warning_of(1e-3, scheme));
  }
  CHECK_FALSE(warning_of(0.0, lagrangian + contact));  // in touch from the start
}
