#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <sstream>

#include "core/document.hpp"
#include "core/overlays.hpp"

namespace tektite {
namespace {

/// As it would be written in a scene, on one line; floating-point numbers with no more digits than they need.
std::string written(const toml::node& node) {
  if (const auto* number = node.as_floating_point()) {
    const auto text = fmt::format("{}", number->get());
    return text.find_first_not_of("-0123456789") == std::string::npos ? text + ".0" : text;  // as no whole number
  }
  if (const auto* text = node.as_string()) return fmt::format("\"{}\"", text->get());
  std::vector<std::string> parts;
  if (const auto* array = node.as_array()) {
    for (const auto& element : *array) parts.push_back(written(element));
    return fmt::format("[{}]", join(parts));
  }
  if (const auto* table = node.as_table()) {
    for (const auto& [key, value] : *table) parts.push_back(fmt::format("{} = {}", key.str(), written(value)));
    return fmt::format("{{ {} }}", join(parts));
  }
  std::ostringstream out;
  node.visit([&](const auto& value) {
    if constexpr (toml::is_value<decltype(value)>) out << value;
  });
  return std::move(out).str();
}

/// Shortened, for a message.
std::string shown(const toml::node& node) {
  auto text = written(node);
  constexpr std::size_t longest = 80;
  if (text.size() > longest) {
    auto end = longest;
    while (end > 0 && (static_cast<unsigned char>(text[end]) & 0xC0) == 0x80) --end;  // not within a character
    text = text.substr(0, end) + "…";
  }
  return text;
}

// What an impact has to do with lies between these, in units of the SI; squares and products of it stay far within what
// a floating-point number holds.
constexpr double largest = 1e30;
constexpr double smallest = 1e-30;

/// Levenshtein distance, for "did you mean".
std::size_t distance(std::string_view a, std::string_view b) {
  std::vector<std::size_t> row(b.size() + 1);
  for (std::size_t j = 0; j <= b.size(); ++j) row[j] = j;
  for (std::size_t i = 1; i <= a.size(); ++i) {
    std::size_t diagonal = row[0];
    row[0] = i;
    for (std::size_t j = 1; j <= b.size(); ++j) {
      const auto above = row[j];
      row[j] = std::min({above + 1, row[j - 1] + 1, diagonal + (a[i - 1] == b[j - 1] ? 0 : 1)});
      diagonal = above;
    }
  }
  return row[b.size()];
}

}  // namespace

std::string Limits::describe() const {
  std::string text;
  if (std::isfinite(least)) text += fmt::format("{} {:g}", least_excluded ? ">" : ">=", least);
  if (std::isfinite(most))
    text += fmt::format("{}{} {:g}", text.empty() ? "" : " and ", most_excluded ? "<" : "<=", most);
  return text.empty() ? "any finite number" : text;
}

Section::Section(Document* document, toml::table* table, std::string path)
    : document_(document),
      table_(table),
      path_(std::move(path)),
      read_(std::make_shared<std::set<std::string, std::less<>>>()) {}

bool Section::has(std::string_view key) const {
  const bool there = table_->contains(key);
  if (!there) read_->emplace(key);  // a key that may be left out is one that may be given: messages offer it
  return there;
}

std::string Section::full(const std::string& key) const {
  if (key.empty()) return path_;
  return path_.empty() ? key : path_ + "." + key;
}

Place Section::place(const std::string& path) const {
  if (const auto at = document_->places_.find(path); at != document_->places_.end()) return at->second;
  if (const auto at = document_->places_.find(path_); at != document_->places_.end()) return at->second;
  return {document_->origin_, 0};
}

InputError Section::fault(const std::string& key, const std::string& reason, const std::string& allowed) const {
  const auto* value = key.empty() ? nullptr : table_->get(key);
  const bool plain = value && !value->is_table();
  return InputError({place(full(key)), full(key), plain ? shown(*value) : std::string(), reason, allowed});
}

toml::node& Section::node(const std::string& key) {
  auto* found = table_->get(key);
  if (!found) throw InputError({place(path_), full(key), {}, "this key is missing", {}});
  read_->insert(key);
  return *found;
}

double Section::convert(const toml::node& node, const std::string& key, const Dimension& expected,
                        const Limits& limits) const {
  const auto wrong = [&](const std::string& reason, const std::string& allowed) {
    return InputError({place(full(key)), full(key), shown(node), reason, allowed});
  };
  double value = 0.0;
  if (const auto text = node.value_exact<std::string>()) {
    const auto quantity = parse_quantity(*text);
    if (!quantity) throw wrong("not a number with a unit", describe(expected));
    if (quantity->dimension != expected && !(quantity->dimension == dimension::none && expected == dimension::none))
      throw wrong(fmt::format("this is {}", describe(quantity->dimension)), describe(expected));
    value = quantity->value;
  } else if (node.is_number()) {
    value = *node.value<double>();
  } else {
    throw wrong("not a number", describe(expected));
  }
  if (!std::isfinite(value)) throw wrong("not a finite number", limits.describe() + " " + si_unit(expected));
  if (std::abs(value) > largest || (value != 0.0 && std::abs(value) < smallest))
    throw wrong("out of all proportion", fmt::format("0, or from {:g} to {:g} in SI units", smallest, largest));
  if (!limits.hold(value)) {
    const auto unit = si_unit(expected);
    throw wrong("out of range", limits.describe() + (unit == "1" ? "" : " " + unit));
  }
  return value;
}

double Section::quantity(const std::string& key, const Dimension& dimension, const Limits& limits) {
  const double value = convert(node(key), key, dimension, limits);
  table_->insert_or_assign(key, value);
  return value;
}

double Section::quantity(const std::string& key, const Dimension& dimension, const Limits& limits, double otherwise) {
  if (!has(key)) table_->insert(key, otherwise);
  return quantity(key, dimension, limits);
}

std::vector<double> Section::quantities(const std::string& key, const Dimension& dimension, std::size_t count,
                                        const Limits& limits) {
  const auto* array = node(key).as_array();
  if (!array || array->size() != count)
    throw fault(key, fmt::format("must be a list of {} values", count), "each " + describe(dimension));
  std::vector<double> values;
  toml::array converted;
  for (const auto& element : *array) {
    values.push_back(convert(element, key, dimension, limits));
    converted.push_back(values.back());
  }
  table_->insert_or_assign(key, converted);
  return values;
}

std::vector<std::vector<double>> Section::points(const std::string& key, const std::vector<Dimension>& coordinates,
                                                 std::size_t least) {
  const auto* array = node(key).as_array();
  if (!array || array->size() < least)
    throw fault(key, fmt::format("must be a list of at least {} points", least), "[[x, y], ...]");
  std::vector<std::vector<double>> points;
  toml::array converted;
  for (const auto& element : *array) {
    const auto* point = element.as_array();
    if (!point || point->size() != coordinates.size())
      throw fault(key, fmt::format("every point must have {} coordinates", coordinates.size()), "[[x, y], ...]");
    auto& values = points.emplace_back();
    toml::array numbers;
    for (std::size_t k = 0; k < coordinates.size(); ++k) {
      values.push_back(convert((*point)[k], key, coordinates[k], limits::any));
      numbers.push_back(values.back());
    }
    converted.push_back(numbers);
  }
  table_->insert_or_assign(key, converted);
  return points;
}

std::int64_t Section::integer(const std::string& key, const Limits& limits) {
  const auto value = node(key).value_exact<std::int64_t>();
  if (!value) throw fault(key, "not a whole number", limits.describe());
  if (!limits.hold(static_cast<double>(*value))) throw fault(key, "out of range", limits.describe());
  return *value;
}

std::int64_t Section::integer(const std::string& key, const Limits& limits, std::int64_t otherwise) {
  if (!has(key)) table_->insert(key, otherwise);
  return integer(key, limits);
}

bool Section::flag(const std::string& key, bool otherwise) {
  if (!has(key)) table_->insert(key, otherwise);
  const auto value = node(key).value_exact<bool>();
  if (!value) throw fault(key, "not a switch", "true, false");
  return *value;
}

std::string Section::text(const std::string& key) {
  const auto value = node(key).value_exact<std::string>();
  if (!value || value->empty()) throw fault(key, "not a text", "a text in quotes");
  return *value;
}

std::string Section::text(const std::string& key, const std::string& otherwise) {
  if (!has(key)) {
    if (otherwise.empty()) return otherwise;
    table_->insert(key, otherwise);
  }
  return text(key);
}

std::vector<std::string> Section::texts(const std::string& key, const std::vector<std::string>& otherwise) {
  if (!has(key)) {
    toml::array words;
    for (const auto& word : otherwise) words.push_back(word);
    table_->insert(key, words);
  }
  const auto* array = node(key).as_array();
  if (!array) throw fault(key, "must be a list of texts", "[\"...\", ...]");
  std::vector<std::string> words;
  for (const auto& element : *array) {
    const auto word = element.value_exact<std::string>();
    if (!word) throw fault(key, "must be a list of texts", "[\"...\", ...]");
    words.push_back(*word);
  }
  return words;
}

std::string Section::choice(const std::string& key, std::span<const std::string> known) {
  if (!has(key)) throw InputError({place(path_), full(key), {}, "this key is missing", join(known)});
  const auto name = node(key).value_exact<std::string>();
  if (!name) throw fault(key, "not a name", join(known));
  if (std::find(known.begin(), known.end(), *name) == known.end()) throw fault(key, "unknown name", join(known));
  return *name;
}

std::string Section::choice(const std::string& key, std::span<const std::string> known, const std::string& otherwise) {
  if (!has(key)) table_->insert(key, otherwise);
  return choice(key, known);
}

Section Section::section(const std::string& key) {
  auto* table = node(key).as_table();
  if (!table) throw fault(key, "must be a table", fmt::format("[{}] or {{ ... }}", full(key)));
  return Section(document_, table, full(key));
}

Section Section::section_or_empty(const std::string& key) {
  if (!has(key)) table_->insert(key, toml::table{});
  return section(key);
}

std::vector<std::pair<std::string, Section>> Section::named_sections(const std::string& key) {
  std::vector<std::pair<std::string, Section>> sections;
  if (!has(key)) return sections;
  auto* table = node(key).as_table();
  if (!table) throw fault(key, "must hold tables", fmt::format("[{}.NAME]", full(key)));
  for (auto& [name, value] : *table) {
    const auto path = full(key) + "." + std::string(name.str());
    if (!value.is_table())
      throw InputError({place(path), path, shown(value), "must be a table", fmt::format("[{}.NAME]", full(key))});
    sections.emplace_back(std::string(name.str()), Section(document_, value.as_table(), path));
  }
  const auto rank = [&](const Section& section) {
    const auto& path = section.path();
    return std::pair(overlay_of(path, document_->places_), place(path).line);
  };
  std::ranges::stable_sort(sections, {}, [&](const auto& named) { return rank(named.second); });
  return sections;
}

std::vector<Section> Section::list(const std::string& key) {
  auto* array = node(key).as_array();
  if (!array || array->empty()) throw fault(key, "must be a list of tables", "[{ ... }, { ... }]");
  std::vector<Section> sections;
  for (std::size_t k = 0; k < array->size(); ++k) {
    auto* table = (*array)[k].as_table();
    if (!table) throw fault(key, "must be a list of tables", "[{ ... }, { ... }]");
    sections.push_back(Section(document_, table, fmt::format("{}[{}]", full(key), k)));
  }
  return sections;
}

void Section::leave(std::span<const std::string_view> keys) {
  for (const auto key : keys) read_->insert(std::string(key));
}

void Section::finish() const {
  for (const auto& [key, value] : *table_) {
    const std::string name(key.str());
    if (read_->contains(name)) continue;
    std::vector<std::string> known(read_->begin(), read_->end());
    std::string reason = "unknown key";
    const auto nearest = std::min_element(known.begin(), known.end(), [&](const auto& a, const auto& b) {
      return distance(a, name) < distance(b, name);
    });
    if (nearest != known.end() && distance(*nearest, name) <= 2) reason += fmt::format(", did you mean {}?", *nearest);
    throw InputError({place(full(name)), full(name), {}, reason, join(known)});
  }
}

}  // namespace tektite
