#pragma once
// Fields by name: generated from the table in fields.def.

#include <array>
#include <optional>
#include <string_view>

#include "core/space.hpp"

namespace tektite {

enum class Field {
#define FIELD(name, symbol, rank, unit, keep) name,
#include "core/fields.def"
#undef FIELD
};

enum class Rank { scalar, vector, symmetric, tensor, integer };
enum class Keep { result, restart, part, scratch };

/// Whether a snapshot has it.
constexpr bool saved(Keep keep) { return keep == Keep::result || keep == Keep::restart; }

struct FieldInfo {
  Field field;
  std::string_view name;
  std::string_view symbol;
  Rank rank;
  std::string_view unit;
  Keep keep;
};

inline constexpr auto field_table = std::to_array<FieldInfo>({
#define FIELD(name, symbol, rank, unit, keep) {Field::name, #name, symbol, Rank::rank, unit, Keep::keep},
#include "core/fields.def"
#undef FIELD
});

inline constexpr int field_count = static_cast<int>(field_table.size());

constexpr const FieldInfo& info(Field field) { return field_table[static_cast<int>(field)]; }

constexpr std::optional<Field> field_named(std::string_view name) {
  for (const auto& row : field_table)
    if (row.name == name) return row.field;
  return std::nullopt;
}

/// Numbers that one particle has of a field of this rank.
constexpr int components_of(Rank rank, Space space) {
  const int d = dimensions_of(space);
  switch (rank) {
    case Rank::scalar:
    case Rank::integer:
      return 1;
    case Rank::vector:
      return d;
    case Rank::symmetric:
      return symmetric_components(d);
    case Rank::tensor:
      return d * d;
  }
  return 0;
}

}  // namespace tektite
