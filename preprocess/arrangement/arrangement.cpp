#include "preprocess/arrangement/arrangement.hpp"

#include <fmt/format.h>

#include <cmath>

#include "core/error.hpp"

namespace tektite::preprocess {

namespace {

long long counted(double spacings) {
  if (!(std::abs(spacings) <= most_spacings))
    throw InputError(fmt::format("{:.2g} spacings are more than can be counted ({:.0g}); is the unit right?", spacings,
                                 most_spacings));
  return static_cast<long long>(spacings);
}

}  // namespace

long long floor_within(double spacings) { return counted(std::floor(spacings + edge_tolerance)); }
long long ceil_within(double spacings) { return counted(std::ceil(spacings - edge_tolerance)); }
long long nearest_whole(double spacings) { return counted(std::round(spacings)); }

}  // namespace tektite::preprocess
