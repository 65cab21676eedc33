#include "preprocess/arrangement/arrangement.hpp"

#include <cmath>

namespace tektite::preprocess {

long long floor_within(double spacings) { return static_cast<long long>(std::floor(spacings + edge_tolerance)); }
long long ceil_within(double spacings) { return static_cast<long long>(std::ceil(spacings - edge_tolerance)); }

}  // namespace tektite::preprocess
