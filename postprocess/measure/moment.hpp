#pragma once
// The moment that a measure looks at: the last snapshot, or with the key `time` the one nearest to it.

#include <fmt/format.h>

#include <optional>

#include "core/error.hpp"
#include "postprocess/measure/measure.hpp"

namespace tektite {

/// The key `time` of a measure, in s.
inline std::optional<double> read_moment(Section& section) {
  if (!section.has("time")) return std::nullopt;
  return section.quantity("time", dimension::time, limits::not_negative);
}

/// What work(snapshot, whole) gives of the moment, whose snapshot has these fields. Throws RunError where the run has
/// not come so far.
template <class Work>
Measured measured_at(const Event& event, std::optional<double> time, const FieldSet& fields, const Work& work) {
  if (!time) return work(event.last_snapshot, event.last);
  constexpr double rounding = 1e-9;
  if (*time > (1.0 + rounding) * event.last.time)
    throw RunError(
        fmt::format("the run ends at {:g} s, before the {:g} s at which it is looked for", event.last.time, *time));
  const auto& file = event.snapshots[nearest_snapshot(event, *time)];
  return work(read_fields(file, fields), read_whole(file, event.symmetry));
}

}  // namespace tektite
