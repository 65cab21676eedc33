// What an impact leaves of a brittle plate: how much of it has failed, and how fast its back face flies off.

#include <algorithm>
#include <array>
#include <cmath>

#include "core/error.hpp"
#include "postprocess/measure/target.hpp"

namespace tektite {

/// Area, in the plane, of the body's particles that have failed, D = 1, in the last snapshot. Of rings it would be a
/// volume.
/// The edge of the failed region is known to a spacing: the uncertainty is half of what the particles beside it cover,
/// taken as those with D between 0 and 1. Keys: body.
Measure read_damaged_area(Section& section, const Declared& declared) {
  if (!is_plane(declared.space)) throw section.fault("", "an area lies in the plane", "plane-strain, plane-stress");
  const auto name = read_body(section, "body", declared);
  const auto take = [=](const Event& event) {
    const auto& particles = event.last_snapshot.particles;
    require_field(particles, Field::damage);
    const auto damage = particles.reals(Field::damage), density = particles.reals(Field::density);
    const auto thickness = [&](std::size_t i) {  // of a sheet, over that at the start
      return particles.has(Field::thickness) ? particles.reals(Field::thickness)[i] : 1.0;
    };
    const auto& whole = event.last;
    const auto body = whole.body_named(name);
    double failed = 0.0, beside = 0.0;
    for (std::size_t i = 0; i < whole.count(); ++i) {
      if (whole.body[i] != body) continue;
      const auto k = whole.source[i];
      const double d = damage[k], area = whole.mass[i] / (density[k] * thickness(k));
      if (d >= 1.0)
        failed += area;
      else if (d > 0.0)
        beside += area;
    }
    return Measured{failed, whole.time, 0.5 * beside, {}};
  };
  return {take, {Field::damage, Field::density, Field::thickness}};
}

/// Largest velocity along the flight of the projectile on the plate's back face in the last snapshot: the mean over the
/// particles that started on that face within two smoothing lengths of the fastest one. The face is known to a spacing:
/// the uncertainty is what the fastest of these particles, and the mean of the layer behind them, differ from it.
/// Keys: body (the plate), projectile, axis.
Measure read_spall_velocity(Section& section, const Declared& declared) {
  const auto find_target = read_target(section, declared, false);
  return [=](const Event& event) {
    const auto target = find_target(event);
    require_across(event, target, Face::back);
    const auto& initial = event.initial;
    const auto& last = event.last;
    const auto body = target.body;
    const auto direction = target.direction;
    const auto place = places_in(initial, last);
    const auto layer = [&](std::size_t i) {  // 0 is the face
      return static_cast<std::size_t>((target.thickness.high - dot(initial.position[place[i]], direction)) /
                                      target.spacing);
    };
    std::size_t fastest = 0;
    double most = -limits::infinite;
    for (std::size_t i = 0; i < last.count(); ++i) {
      const double speed = dot(last.velocity[i], direction);
      if (last.body[i] != body || layer(i) > 0 || speed <= most) continue;
      most = speed;
      fastest = i;
    }
    std::array<double, 2> sum{}, count{};  // of the face, and of the layer behind it
    for (std::size_t i = 0; i < last.count(); ++i) {
      const auto apart = initial.position[place[i]] - initial.position[place[fastest]];
      if (last.body[i] != body || layer(i) > 1 || norm(apart) > 2.0 * last.smoothing_length[fastest]) continue;
      sum[layer(i)] += dot(last.velocity[i], direction);
      ++count[layer(i)];
    }
    const double mean = sum[0] / count[0], behind = count[1] > 0.0 ? sum[1] / count[1] : mean;
    return Measured{mean, last.time, std::max(most - mean, std::abs(behind - mean)), {}};
  };
}

}  // namespace tektite
