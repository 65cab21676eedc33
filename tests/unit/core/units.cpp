// Units at the border of a scene.
#include "core/units.hpp"

#include <catch2/catch.hpp>
#include <cmath>
#include <string>
#include <vector>

namespace tektite {
namespace {

struct Reading {
  std::string text;
  double value;
  Dimension dimension;
};

// Products of a few decimal factors: each rounds once or twice.
constexpr double rounding = 4e-16;

TEST_CASE("Units: each unit converts to its SI value and dimension") {
  const Dimension force{1, 1, -2, 0};
  const Dimension power{2, 1, -3, 0};
  const double pi = std::acos(-1.0);
  const auto reading = GENERATE_COPY(values<Reading>({
      {"1 m", 1.0, dimension::length},
      {"2.5 g", 2.5e-3, dimension::mass},
      {"3 s", 3.0, dimension::time},
      {"300 K", 300.0, dimension::temperature},
      {"7 N", 7.0, force},
      {"1 Pa", 1.0, dimension::pressure},
      {"1 bar", 1e5, dimension::pressure},
      {"4 J", 4.0, dimension::energy},
      {"5 W", 5.0, power},
      {"6 Hz", 6.0, dimension::rate},
      {"2 in", 0.0508, dimension::length},
      {"180 deg", pi, dimension::none},
      {"5 %", 0.05, dimension::none},
      {"12", 12.0, dimension::none},
      {"1 1/s", 1.0, dimension::rate},
  }));
  const auto quantity = parse_quantity(reading.text);
  INFO(reading.text);
  REQUIRE(quantity);
  CHECK(quantity->value == Approx(reading.value).epsilon(rounding));
  CHECK(quantity->dimension == reading.dimension);
}

TEST_CASE("Units: every prefix scales every unit that takes one") {
  const std::vector<std::pair<std::string, double>> prefixes{{"n", 1e-9}, {"u", 1e-6}, {"µ", 1e-6}, {"μ", 1e-6},
                                                             {"m", 1e-3}, {"c", 1e-2}, {"k", 1e3},  {"M", 1e6},
                                                             {"G", 1e9},  {"T", 1e12}};
  for (const std::string unit : {"m", "g", "s", "K", "N", "Pa", "bar", "J", "W", "Hz"}) {
    const auto plain = parse_quantity("1 " + unit);
    REQUIRE(plain);
    for (const auto& [prefix, factor] : prefixes) {
      INFO(prefix + unit);
      const auto scaled = parse_quantity("1 " + prefix + unit);
      REQUIRE(scaled);
      CHECK(scaled->value == Approx(factor * plain->value).epsilon(rounding));
      CHECK(scaled->dimension == plain->dimension);
    }
  }
}

TEST_CASE("Units: products, quotients, powers and brackets are read") {
  const auto reading = GENERATE(values<Reading>({
      {"3.1 km/s", 3100.0, dimension::speed},
      {"2785 kg/m3", 2785.0, dimension::density},
      {"2785 kg/m^3", 2785.0, dimension::density},
      {"2.785 g/cm3", 2785.0, dimension::density},
      {"2785 kg m-3", 2785.0, dimension::density},
      {"2785 kg·m^-3", 2785.0, dimension::density},
      {"0.532 cm/us", 5320.0, dimension::speed},
      {"1.93 Mbar", 1.93e11, dimension::pressure},
      {"875 J/(kg K)", 875.0, dimension::specific_heat},
      {"875 J/kg/K", 875.0, dimension::specific_heat},
      {"875 (J/kg)/K", 875.0, dimension::specific_heat},
      {"2 MJ/kg", 2e6, dimension::specific_energy},
      {"1 kg*m2/s2", 1.0, dimension::energy},
      {"3 mm2", 3e-6, dimension::area},
      {"3 cm3", 3e-6, dimension::volume},
      {"1e5 1/s", 1e5, dimension::rate},
      {"  +2 mm ", 2e-3, dimension::length},
      {"-0.5 cm", -0.5e-2, dimension::length},
      {"1e-3m", 1e-3, dimension::length},
  }));
  INFO(reading.text);
  const auto quantity = parse_quantity(reading.text);
  REQUIRE(quantity);
  CHECK(quantity->value == Approx(reading.value).epsilon(rounding));
  CHECK(quantity->dimension == reading.dimension);
}

TEST_CASE("Units: nonsense is no quantity") {
  const std::string text = GENERATE(as<std::string>(), "", " ", "km", "1 furlong", "1 m/", "1 /", "1 (m", "1 m)",
                                    "1 ()", "1 m^", "1 m^x", "1 m^99", "1 kin", "1,5 m", "1 m//s", "0x10 m", "--1 m",
                                    "1 ((((((((((m))))))))))", "one metre", "1 m = 2", "1 M", "1 µ", "++1 m", "+-1 m");
  INFO('"' + text + '"');
  CHECK_FALSE(parse_quantity(text));
}

TEST_CASE("Units: the SI unit of each dimension reads back as one of it") {
  for (const auto& known :
       {dimension::none, dimension::length, dimension::area, dimension::volume, dimension::time, dimension::rate,
        dimension::speed, dimension::mass, dimension::density, dimension::pressure, dimension::energy,
        dimension::specific_energy, dimension::specific_heat, dimension::temperature, Dimension{1, 2, -3, -1}}) {
    INFO(si_unit(known));
    const auto quantity = parse_quantity("1 " + si_unit(known));
    REQUIRE(quantity);
    CHECK(quantity->value == 1.0);
    CHECK(quantity->dimension == known);
  }
}

TEST_CASE("Units: a dimension is described by name and example, or by its unit where it has no name") {
  CHECK(describe(dimension::speed) == "a speed (m/s, km/s)");
  CHECK(describe(dimension::none) == "a plain number");
  CHECK(describe(Dimension{0, 0, 2, 0}) == "a quantity in s2");
}

}  // namespace
}  // namespace tektite
