#pragma once
// Units at the border: a scene may say "3.1 km/s" or "0.3 GPa"; inside everything is SI. Written here, and not with
// UDUNITS, because that needs its XML database on every machine that solves and reads "8 us" in a way of its own.

#include <optional>
#include <string>
#include <string_view>

namespace tektite {

/// Exponents of metre, kilogram, second and kelvin.
struct Dimension {
  int metre = 0;
  int kilogram = 0;
  int second = 0;
  int kelvin = 0;
  bool operator==(const Dimension&) const = default;
};

namespace dimension {
inline constexpr Dimension none{};
inline constexpr Dimension length{1, 0, 0, 0};
inline constexpr Dimension area{2, 0, 0, 0};
inline constexpr Dimension volume{3, 0, 0, 0};
inline constexpr Dimension time{0, 0, 1, 0};
inline constexpr Dimension rate{0, 0, -1, 0};
inline constexpr Dimension speed{1, 0, -1, 0};
inline constexpr Dimension mass{0, 1, 0, 0};
inline constexpr Dimension density{-3, 1, 0, 0};
inline constexpr Dimension pressure{-1, 1, -2, 0};
inline constexpr Dimension energy{2, 1, -2, 0};
inline constexpr Dimension specific_energy{2, 0, -2, 0};
inline constexpr Dimension specific_heat{2, 0, -2, -1};
inline constexpr Dimension temperature{0, 0, 0, 1};
}  // namespace dimension

/// A name with examples for messages: "speed (m/s, km/s)".
std::string describe(const Dimension& dimension);

/// The SI unit of a dimension, as "kg/m3"; "1" where there is none.
std::string si_unit(const Dimension& dimension);

struct Quantity {
  double value = 0.0;  ///< in SI
  Dimension dimension;
};

/// Reads "3.1 km/s", "2785 kg/m^3", "875 J/(kg K)", "12"; nullopt where the text is no quantity.
std::optional<Quantity> parse_quantity(std::string_view text);

}  // namespace tektite
