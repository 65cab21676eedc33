#include "core/units.hpp"

#include <fmt/format.h>

#include <array>
#include <charconv>
#include <cmath>

namespace tektite {
namespace {

struct Unit {
  std::string_view symbol;
  double factor;
  Dimension dimension;
  bool prefixable;
};

constexpr double pi = 3.14159265358979323846;

constexpr std::array<Unit, 14> units{{
    {"m", 1.0, dimension::length, true},
    {"g", 1e-3, dimension::mass, true},
    {"s", 1.0, dimension::time, true},
    {"K", 1.0, dimension::temperature, true},
    {"N", 1.0, {1, 1, -2, 0}, true},
    {"Pa", 1.0, dimension::pressure, true},
    {"bar", 1e5, dimension::pressure, true},
    {"J", 1.0, dimension::energy, true},
    {"W", 1.0, {2, 1, -3, 0}, true},
    {"Hz", 1.0, dimension::rate, true},
    {"in", 0.0254, dimension::length, false},
    {"deg", pi / 180.0, dimension::none, false},
    {"%", 0.01, dimension::none, false},
    {"1", 1.0, dimension::none, false},
}};

struct Prefix {
  std::string_view symbol;
  double factor;
};

constexpr std::array<Prefix, 10> prefixes{{{"n", 1e-9},
                                           {"u", 1e-6},
                                           {"µ", 1e-6},
                                           {"μ", 1e-6},
                                           {"m", 1e-3},
                                           {"c", 1e-2},
                                           {"k", 1e3},
                                           {"M", 1e6},
                                           {"G", 1e9},
                                           {"T", 1e12}}};

std::optional<Quantity> unit_named(std::string_view symbol) {
  for (const auto& unit : units)
    if (unit.symbol == symbol) return Quantity{unit.factor, unit.dimension};
  for (const auto& prefix : prefixes) {
    if (!symbol.starts_with(prefix.symbol)) continue;
    const auto rest = symbol.substr(prefix.symbol.size());
    for (const auto& unit : units)
      if (unit.prefixable && unit.symbol == rest) return Quantity{prefix.factor * unit.factor, unit.dimension};
  }
  return std::nullopt;
}

void multiply(Quantity& product, const Quantity& factor, int power) {
  product.value *= std::pow(factor.value, power);
  product.dimension.metre += power * factor.dimension.metre;
  product.dimension.kilogram += power * factor.dimension.kilogram;
  product.dimension.second += power * factor.dimension.second;
  product.dimension.kelvin += power * factor.dimension.kelvin;
}

/// Recursive descent over products, quotients, powers and brackets of units.
class UnitReader {
 public:
  explicit UnitReader(std::string_view text) : text_(text) {}

  std::optional<Quantity> whole() {
    auto product = expression();
    if (!product || position_ != text_.size()) return std::nullopt;
    return product;
  }

 private:
  std::optional<Quantity> expression() {
    Quantity product{1.0, {}};
    int sign = 1;
    for (bool first = true;; first = false) {
      skip_spaces();
      if (position_ == text_.size() || text_[position_] == ')') {
        return first ? std::nullopt : std::optional(product);
      }
      if (!first) {
        sign = 1;
        if (text_[position_] == '/') {
          sign = -1;
          ++position_;
        } else if (text_[position_] == '*') {
          ++position_;
        } else if (text_.substr(position_).starts_with("·")) {
          position_ += std::string_view("·").size();
        }
        skip_spaces();
      }
      const auto factor = factor_with_power();
      if (!factor) return std::nullopt;
      multiply(product, *factor, sign);
    }
  }

  std::optional<Quantity> factor_with_power() {
    std::optional<Quantity> base;
    if (position_ < text_.size() && text_[position_] == '(') {
      constexpr int deepest = 8;
      if (++depth_ > deepest) return std::nullopt;
      ++position_;
      base = expression();
      if (!base || position_ == text_.size()) return std::nullopt;
      ++position_;
      --depth_;
    } else {
      const auto start = position_;
      if (position_ < text_.size() && (text_[position_] == '1' || text_[position_] == '%')) {
        ++position_;
      } else {
        while (position_ < text_.size() && is_letter(text_[position_]) && !text_.substr(position_).starts_with("·"))
          ++position_;
      }
      base = unit_named(text_.substr(start, position_ - start));
      if (!base) return std::nullopt;
    }
    const auto exponent = power();
    if (!exponent) return std::nullopt;
    Quantity result{1.0, {}};
    multiply(result, *base, *exponent);
    return result;
  }

  std::optional<int> power() {
    auto at = position_;
    const bool caret = at < text_.size() && text_[at] == '^';
    if (caret) ++at;
    int exponent = 1;
    const auto [end, fault] = std::from_chars(text_.data() + at, text_.data() + text_.size(), exponent);
    if (fault != std::errc{}) return caret ? std::nullopt : std::optional(1);
    if (exponent < -9 || exponent > 9) return std::nullopt;
    position_ = static_cast<std::size_t>(end - text_.data());
    return exponent;
  }

  static bool is_letter(char c) {
    return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || static_cast<unsigned char>(c) >= 0x80;
  }
  void skip_spaces() {
    while (position_ < text_.size() && text_[position_] == ' ') ++position_;
  }

  std::string_view text_;
  std::size_t position_ = 0;
  int depth_ = 0;
};

struct NamedDimension {
  Dimension dimension;
  std::string_view name;
  std::string_view examples;
};

constexpr std::array<NamedDimension, 14> named_dimensions{{
    {dimension::none, "a plain number", ""},
    {dimension::length, "a length", "m, cm, mm, um"},
    {dimension::area, "an area", "m2, cm2"},
    {dimension::volume, "a volume", "m3, cm3"},
    {dimension::time, "a time", "s, ms, us"},
    {dimension::rate, "a rate", "1/s"},
    {dimension::speed, "a speed", "m/s, km/s"},
    {dimension::mass, "a mass", "kg, g"},
    {dimension::density, "a density", "kg/m3, g/cm3"},
    {dimension::pressure, "a pressure", "Pa, MPa, GPa, Mbar"},
    {dimension::energy, "an energy", "J, kJ"},
    {dimension::specific_energy, "a specific energy", "J/kg"},
    {dimension::specific_heat, "a specific heat", "J/(kg K)"},
    {dimension::temperature, "a temperature", "K"},
}};

}  // namespace

std::string describe(const Dimension& dimension) {
  for (const auto& entry : named_dimensions)
    if (entry.dimension == dimension)
      return entry.examples.empty() ? std::string(entry.name) : fmt::format("{} ({})", entry.name, entry.examples);
  return "a quantity in " + si_unit(dimension);
}

std::string si_unit(const Dimension& dimension) {
  if (dimension == dimension::pressure) return "Pa";
  if (dimension == dimension::energy) return "J";
  if (dimension == dimension::specific_energy) return "J/kg";
  if (dimension == dimension::specific_heat) return "J/(kg K)";
  const std::array<std::pair<const char*, int>, 4> base{
      {{"kg", dimension.kilogram}, {"m", dimension.metre}, {"s", dimension.second}, {"K", dimension.kelvin}}};
  std::string above, below;
  for (const auto& [symbol, power] : base) {
    if (power == 0) continue;
    auto& side = power > 0 ? above : below;
    if (!side.empty()) side += ' ';
    side += symbol;
    if (std::abs(power) > 1) side += std::to_string(std::abs(power));
  }
  if (below.empty()) return above.empty() ? "1" : above;
  return (above.empty() ? "1" : above) + "/" + (below.find(' ') == std::string::npos ? below : "(" + below + ")");
}

std::optional<Quantity> parse_quantity(std::string_view text) {
  const auto first = text.find_first_not_of(' ');
  if (first == std::string_view::npos) return std::nullopt;
  text = text.substr(first, text.find_last_not_of(' ') + 1 - first);
  if (text.starts_with('+')) {
    text.remove_prefix(1);
    if (text.starts_with('-')) return std::nullopt;
  }
  double number = 0.0;
  const auto [end, fault] = std::from_chars(text.data(), text.data() + text.size(), number);
  if (fault != std::errc{}) return std::nullopt;
  const auto rest = text.substr(static_cast<std::size_t>(end - text.data()));
  if (rest.empty()) return Quantity{number, {}};
  auto unit = UnitReader(rest).whole();
  if (!unit) return std::nullopt;
  unit->value *= number;
  return unit;
}

}  // namespace tektite
