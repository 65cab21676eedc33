// A pulse of velocity that an elastic body carries, against d'Alembert's solution: of v(x, 0) = f(x) without strain
// v(x, t) = (f(x - c t) + f(x + c t))/2, with f = speed cos⁴(π (x - centre)/width), in the body's reference.

#include <algorithm>
#include <cmath>
#include <numbers>

#include "core/error.hpp"
#include "postprocess/measure/measure.hpp"

namespace tektite {
namespace {

struct Pulse {
  double speed, centre, width, wave_speed;

  double initial(double x) const {
    const double share = (x - centre) / width;
    return std::abs(share) < 0.5 ? speed * std::pow(std::cos(std::numbers::pi * share), 4) : 0.0;
  }
  double at(double x, double t) const { return 0.5 * (initial(x - wave_speed * t) + initial(x + wave_speed * t)); }
};

}  // namespace

/// Sum over the particles of |v - exact| in the last snapshot, over that of |exact|. Keys: body; speed, centre and
/// width as those of the initial velocity; wave_speed, of longitudinal waves. A particle is where the wave is within
/// half a spacing: the uncertainty is the error of moving both halves by that.
Measure read_error_l1_pulse(Section& section, const Declared& declared) {
  if (declared.space != Space::line) throw section.fault("", "the pulse runs along a line", "line");
  const auto name = read_body(section, "body", declared);
  Pulse pulse{};
  pulse.speed = section.quantity("speed", dimension::speed);
  pulse.centre = section.quantity("centre", dimension::length);
  pulse.width = section.quantity("width", dimension::length, limits::positive);
  pulse.wave_speed = section.quantity("wave_speed", dimension::speed, limits::positive);
  return [=](const Event& event) {
    const auto body = event.last.body_named(name);
    const double half = 0.5 * event.last.bodies[static_cast<std::size_t>(body)].spacing;
    const auto place = places_in(event.initial, event.last);
    double error = 0.0, norm = 0.0, moved = 0.0;
    for (std::size_t i = 0; i < event.last.count(); ++i) {
      if (event.last.body[i] != body) continue;
      const double x = event.initial.position[place[i]][0], t = event.last.time, delay = half / pulse.wave_speed;
      error += std::abs(event.last.velocity[i][0] - pulse.at(x, t));
      norm += std::abs(pulse.at(x, t));
      moved += std::abs(pulse.at(x, t + delay) - pulse.at(x, t));
    }
    if (norm == 0.0) throw RunError("the pulse has left the body");
    return Measured{error / norm, event.last.time, moved / norm, {}};
  };
}

}  // namespace tektite
