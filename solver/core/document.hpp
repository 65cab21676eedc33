#pragma once
// A scene as text: TOML with one variant applied, later settings laid over it, and the place of every key remembered.
// Section reads it key by key, checks, converts to SI and writes the value that is in effect back, so that after
// reading the document is the effective scene that travels with the results.

#include <toml++/toml.h>
#include <cstdint>
#include <limits>
#include <map>
#include <memory>
#include <optional>
#include <set>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "core/error.hpp"
#include "core/units.hpp"

namespace tektite {

/// What numbers a key may take.
struct Limits {
  double least = -std::numeric_limits<double>::infinity();
  double most = std::numeric_limits<double>::infinity();
  bool least_excluded = false;
  bool most_excluded = false;

  bool hold(double value) const {
    return (least_excluded ? value > least : value >= least) && (most_excluded ? value < most : value <= most);
  }
  std::string describe() const;
};

namespace limits {
inline constexpr double infinite = std::numeric_limits<double>::infinity();
inline constexpr Limits any{};
inline constexpr Limits positive{0.0, infinite, true, false};
inline constexpr Limits not_negative{0.0, infinite, false, false};
inline constexpr Limits fraction{0.0, 1.0, false, false};
}  // namespace limits

class Section;

class Document {
 public:
  /// Reads a scene file, lays [variant.NAME] over it (none where the name is empty) and then each setting "KEY=VALUE".
  /// A table in a variant that gives another `type` or `model` than the scene replaces the scene's table whole;
  /// otherwise keys are overridden one by one. What remains of `variant` is the name. Throws InputError.
  static Document load(const std::string& path, const std::string& variant, const std::vector<std::string>& settings);

  /// Reads an effective scene from text, as it stands in a particle file; `origin` is what messages name for a key of
  /// which the text does not tell where it came from.
  static Document parse(std::string_view text, const std::string& origin);

  /// Lays one more "KEY=VALUE" over it; `option` is what messages name as its place. Throws InputError.
  void set(const std::string& setting, const std::string& option);

  Section root();
  std::vector<std::string> variants() const { return variants_; }
  /// The variant that is laid over; empty where there is none.
  const std::string& variant() const { return variant_; }
  const std::string& origin() const { return origin_; }

  /// The fault of a key, told by who does not know the file, with the key's place, or that of the nearest table about
  /// it.
  InputError placed(const InputError& fault) const;

  /// The document as TOML, with comments that tell the variant and the file and line of each key, which parse() reads.
  std::string text() const;

 private:
  friend class Section;
  void remember(const toml::node& node, const std::string& path, const std::string& file);
  void lay_over(toml::table& base, const toml::table& over, const std::string& path, const std::string& over_path);

  std::shared_ptr<toml::table> table_;
  std::map<std::string, Place> places_;
  std::vector<std::string> variants_;
  std::string variant_;
  std::string origin_;
};

/// One table of a document, read once from top to bottom. Every reader converts and checks; a fault is an InputError
/// that names file, line, key, value, reason and what is allowed.
class Section {
 public:
  bool has(std::string_view key) const;
  /// Whether the key is there and holds a table, for keys that may hold a table or something shorter.
  bool has_table(std::string_view key) const { return table_->get(key) && table_->get(key)->is_table(); }

  /// Quantities with unit; a bare number is SI.
  double quantity(const std::string& key, const Dimension& dimension, const Limits& limits = {});
  double quantity(const std::string& key, const Dimension& dimension, const Limits& limits, double otherwise);
  std::vector<double> quantities(const std::string& key, const Dimension& dimension, std::size_t count,
                                 const Limits& limits = {});
  /// A list of at least `least` points, each with one quantity for every one of `coordinates`.
  std::vector<std::vector<double>> points(const std::string& key, const std::vector<Dimension>& coordinates,
                                          std::size_t least);

  std::int64_t integer(const std::string& key, const Limits& limits = {});
  std::int64_t integer(const std::string& key, const Limits& limits, std::int64_t otherwise);
  bool flag(const std::string& key, bool otherwise);
  std::string text(const std::string& key);
  std::string text(const std::string& key, const std::string& otherwise);
  std::vector<std::string> texts(const std::string& key, const std::vector<std::string>& otherwise);

  /// A name out of a list; an unknown one is answered with the list.
  std::string choice(const std::string& key, std::span<const std::string> known);
  std::string choice(const std::string& key, std::span<const std::string> known, const std::string& otherwise);

  Section section(const std::string& key);
  /// The table under a key, made empty where it is missing.
  Section section_or_empty(const std::string& key);
  /// The tables [key.NAME] in the order in which the file has them.
  std::vector<std::pair<std::string, Section>> named_sections(const std::string& key);
  /// A list of tables: key = [{...}, {...}].
  std::vector<Section> list(const std::string& key);

  /// Leaves these keys to another stage.
  void leave(std::span<const std::string_view> keys);
  /// Every key has been read: one that has not is an error.
  void finish() const;

  const std::string& path() const { return path_; }
  /// The file that the document was read from: paths in a scene are relative to its folder.
  const std::string& origin() const { return document_->origin(); }
  /// The error for a key of this section (or the section itself, where key is empty).
  InputError fault(const std::string& key, const std::string& reason, const std::string& allowed = {}) const;

 private:
  friend class Document;
  Section(Document* document, toml::table* table, std::string path);
  toml::node& node(const std::string& key);
  std::string full(const std::string& key) const;
  Place place(const std::string& path) const;
  double convert(const toml::node& node, const std::string& key, const Dimension& dimension,
                 const Limits& limits) const;

  Document* document_;
  toml::table* table_;
  std::string path_;
  std::shared_ptr<std::set<std::string, std::less<>>> read_;
};

/// "a, b, c"
std::string join(std::span<const std::string> words);

}  // namespace tektite
