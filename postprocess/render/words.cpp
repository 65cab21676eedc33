#include "postprocess/render/words.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "postprocess/shown_unit.hpp"

namespace tektite {

std::string readable(std::string name) {
  std::replace(name.begin(), name.end(), '_', ' ');
  return name;
}

std::string time_in_words(double time, const std::optional<double>& contact) {
  const double shown = contact ? time - *contact : time;
  const auto unit = shown_unit(shown, "s");
  return fmt::format("{:.3f} {}{}", shown * unit.factor, unit.label, contact ? " after contact" : "");
}

}  // namespace tektite
