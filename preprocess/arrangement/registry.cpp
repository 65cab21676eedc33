#include "preprocess/arrangement/registry.hpp"

#include <fmt/format.h>

#include <array>

#include "preprocess/arrangement/arrangements.hpp"

namespace tektite::preprocess {
namespace {

struct ArrangementRow {
  const char* name;
  int least_dimensions;
  int most_dimensions;
  ArrangementPointer (*read)(Section&, int);
};

constexpr std::array<ArrangementRow, 6> arrangements{{
    {"lattice", 1, 3, read_lattice},
    {"rings", 2, 2, read_rings},
    {"lattice-with-rings", 2, 2, read_lattice_with_rings},
    {"shells", 3, 3, read_shells},
    {"hexagonal", 2, 2, read_hexagonal},
    {"close-packed", 3, 3, read_close_packed},
}};

bool fits(const ArrangementRow& row, int dimensions) {
  return row.least_dimensions <= dimensions && dimensions <= row.most_dimensions;
}

}  // namespace

ArrangementChoice read_arrangement(Section section, int dimensions) {
  std::vector<std::string> allowed;
  for (const auto& row : arrangements)
    if (fits(row, dimensions)) allowed.emplace_back(row.name);
  const auto type = section.text("type", "lattice");
  ArrangementChoice choice;
  for (const auto& row : arrangements) {
    if (row.name != type) continue;
    if (!fits(row, dimensions))
      throw section.fault("type", fmt::format("this arrangement has no place in a space of {} dimensions", dimensions),
                          join(allowed));
    choice.arrangement = row.read(section, dimensions);
  }
  if (!choice.arrangement) throw section.fault("type", "unknown arrangement", join(allowed));
  if (section.has("count")) choice.wished_count = section.integer("count", limits::positive);
  const std::array<std::string, 2> masses{"cell", "exact"};
  if (section.choice("mass", masses, "cell") == "exact") choice.mass = MassRule::exact;
  section.finish();
  return choice;
}

}  // namespace tektite::preprocess
