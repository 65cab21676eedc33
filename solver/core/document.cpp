#include "core/document.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <fstream>
#include <optional>
#include <sstream>

#include "core/overlays.hpp"
#include "core/plain_name.hpp"
#include "core/unreadable.hpp"

namespace tektite {
namespace {

std::string joined(const std::string& path, std::string_view key) {
  return path.empty() ? std::string(key) : fmt::format("{}.{}", path, key);
}

std::string read_file(const std::string& path) {
  std::ifstream file(path, std::ios::binary);
  if (!file) throw InputError({{path, 0}, {}, {}, "this file cannot be opened", "a TOML file"});
  std::string content;
  std::array<char, 65536> part;
  while (file.read(part.data(), part.size()) || file.gcount() > 0)
    content.append(part.data(), static_cast<std::size_t>(file.gcount()));
  if (file.bad()) throw InputError({{path, 0}, {}, {}, "this file cannot be read", "a TOML file"});
  return content;
}

toml::table parse_toml(std::string_view text, const std::string& origin) {
  if (const auto found = first_unreadable(text))
    throw InputError({{origin, static_cast<int>(1 + std::ranges::count(text.substr(0, found->at), '\n'))},
                      {},
                      {},
                      fmt::format("not TOML: {}", found->what),
                      found->allowed});
  try {
    return toml::parse(text, origin);
  } catch (const toml::parse_error& fault) {
    throw InputError({{origin, static_cast<int>(fault.source().begin.line)},
                      {},
                      {},
                      fmt::format("not TOML: {}", fault.description()),
                      {}});
  }
}

/// Nothing where it is not TOML.
std::optional<toml::table> parse_setting(const std::string& text) {
  if (first_unreadable(text)) return std::nullopt;
  try {
    return toml::parse(text);
  } catch (const toml::parse_error&) {
    return std::nullopt;
  }
}

// Below an effective scene stand comments that tell the variant, and where each key came from: one line for a file, and
// below it one for each key of it. So a fault found by a later stage still names the line that a person wrote.
constexpr std::string_view variant_mark = "#@ variant ";
constexpr std::string_view file_mark = "#@ file ";
constexpr std::string_view line_mark = "#@ line ";

std::string places_as_comments(const std::map<std::string, Place>& places) {
  std::map<std::string, std::string> lines_by_file;
  for (const auto& [key, place] : places)
    if (key != "variant" && !key.starts_with("variant.") && key.find_first_of("\r\n") == std::string::npos)
      lines_by_file[place.file] += fmt::format("{}{} {}\n", line_mark, place.line, key);
  std::string comments;
  for (const auto& [file, lines] : lines_by_file) {
    auto name = file;
    std::replace(name.begin(), name.end(), '\n', ' ');
    comments += fmt::format("{}{}\n{}", file_mark, name, lines);
  }
  return comments;
}

/// These comments alone: the lines at the end that begin with a mark, since a text within the scene may hold one too.
std::string_view comments_below(std::string_view text) {
  std::size_t begin = 0;
  for (std::size_t line = 0; line < text.size();) {
    const auto next = std::min(text.find('\n', line), text.size() - 1) + 1;
    if (!text.substr(line).starts_with("#@ ")) begin = next;
    line = next;
  }
  return text.substr(begin);
}

std::string variant_from_comments(std::string_view text) {
  std::istringstream lines{std::string(comments_below(text))};
  for (std::string line; std::getline(lines, line);)
    if (line.starts_with(variant_mark)) return line.substr(variant_mark.size());
  return {};
}

std::map<std::string, Place> places_from_comments(std::string_view text) {
  std::map<std::string, Place> places;
  std::string file;
  std::istringstream lines{std::string(comments_below(text))};
  for (std::string line; std::getline(lines, line);) {
    if (line.starts_with(file_mark)) file = line.substr(file_mark.size());
    if (!line.starts_with(line_mark)) continue;
    std::istringstream words(line.substr(line_mark.size()));
    int number = 0;
    std::string key;
    if (words >> number && words.get() == ' ' && std::getline(words, key)) places[key] = {file, number};
    if (words.eof() && key.empty()) places[""] = {file, number};
  }
  return places;
}

/// A table of another type or model than the one below it stands for something else.
bool replaces(const toml::table& base, const toml::table& over) {
  for (const auto* key : {"type", "model"}) {
    const auto below = base[key].value<std::string>();
    const auto above = over[key].value<std::string>();
    if (below && above && *below != *above) return true;
  }
  return false;
}

}  // namespace

Document Document::load(const std::string& path, const std::string& variant, const std::vector<std::string>& settings) {
  auto document = parse(read_file(path), path);
  std::optional<toml::table> chosen;
  if (const auto* node = document.table_->get("variant")) {
    const auto* all = node->as_table();
    if (!all) throw document.root().fault("variant", "must hold tables", "[variant.NAME]");
    for (const auto& [name, value] : *all) {
      if (!is_plain_name(name.str()))
        throw document.root().fault("variant", fmt::format("\"{}\" names a folder, so it must be plain", name.str()),
                                    plain_characters);
      if (!value.is_table()) throw document.root().fault("variant." + std::string(name.str()), "must be a table");
      document.variants_.emplace_back(name.str());
      if (name.str() != variant) continue;
      chosen = *value.as_table();
      document.remember(value, overlay_path(0), path);
    }
    document.table_->erase("variant");
  }
  if (!variant.empty() && !chosen)
    throw InputError({{path, 0},
                      "variant",
                      '"' + variant + '"',
                      "no such variant",
                      document.variants_.empty() ? "this scene has none" : join(document.variants_)});
  if (chosen) document.lay_over(*document.table_, *chosen, "", overlay_path(0));
  document.variant_ = variant;
  for (const auto& setting : settings) document.set(setting, "--set " + setting);
  return document;
}

Document Document::parse(std::string_view text, const std::string& origin) {
  Document document;
  document.origin_ = origin;
  document.table_ = std::make_shared<toml::table>(parse_toml(text, origin));
  document.remember(*document.table_, "", origin);
  document.variant_ = variant_from_comments(text);
  if (auto places = places_from_comments(text); !places.empty()) document.places_ = std::move(places);
  return document;
}

InputError Document::placed(const InputError& fault) const {
  auto told = fault.fault();
  if (!told.place.file.empty()) return fault;
  auto path = told.key;
  while (!path.empty() && !places_.contains(path)) {
    const auto dot = path.rfind('.');
    path.resize(dot == std::string::npos ? 0 : dot);
  }
  told.place = places_.contains(path) ? places_.at(path) : Place{origin_, 0};
  return InputError(told);
}

Section Document::root() { return Section(this, table_.get(), ""); }

std::string Document::text() const {
  std::ostringstream out;
  out << toml::toml_formatter(*table_,
                              toml::toml_formatter::default_flags & ~toml::format_flags::allow_literal_strings);
  out << '\n';
  if (!variant_.empty()) out << variant_mark << variant_ << '\n';
  return std::move(out).str() + places_as_comments(places_);
}

void Document::remember(const toml::node& node, const std::string& path, const std::string& file) {
  places_[path] = {file, static_cast<int>(node.source().begin.line)};
  if (const auto* table = node.as_table()) {
    for (const auto& [key, value] : *table) {
      const auto below = joined(path, key.str());
      remember(value, below, file);
      places_[below].line = static_cast<int>(key.source().begin.line);
    }
  } else if (const auto* array = node.as_array()) {
    for (std::size_t k = 0; k < array->size(); ++k)
      if ((*array)[k].is_table()) remember((*array)[k], fmt::format("{}[{}]", path, k), file);
  }
}

void Document::lay_over(toml::table& base, const toml::table& over, const std::string& path,
                        const std::string& over_path) {
  for (const auto& [key, value] : over) {
    const auto below = joined(path, key.str());
    const auto above = joined(over_path, key.str());
    auto* there = base.get_as<toml::table>(key.str());
    if (there && value.is_table() && !replaces(*there, *value.as_table())) {
      lay_over(*there, *value.as_table(), below, above);
      continue;
    }
    base.insert_or_assign(key.str(), value);
    std::map<std::string, Place> moved;
    for (const auto& [name, place] : places_)
      if (name.starts_with(above)) moved[below + name.substr(above.size())] = place;
    for (auto& [name, place] : moved) places_[name] = place;
  }
}

void Document::set(const std::string& setting, const std::string& option) {
  const auto equals = setting.find('=');
  const InputFault fault{{option, 0}, {}, {}, "not a setting", "KEY=VALUE, such as scheme.courant=0.2"};
  if (equals == std::string::npos || equals == 0 || setting.find('\n') != std::string::npos) throw InputError(fault);
  const auto key = setting.substr(0, equals);
  const auto value = setting.substr(equals + 1);
  auto over = parse_setting(key + " = " + value);
  if (!over) over = parse_setting(key + " = \"" + value + '"');
  if (!over) throw InputError(fault);
  const auto path = overlay_path(overlay_count(places_));
  Document part;
  part.remember(*over, path, fault.place.file);
  for (auto& [name, place] : part.places_) places_[name] = {place.file, 0};
  lay_over(*table_, *over, "", path);
}

std::string join(std::span<const std::string> words) { return fmt::format("{}", fmt::join(words, ", ")); }

}  // namespace tektite
