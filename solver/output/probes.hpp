#pragma once

#include <map>
#include <string>
#include <vector>

#include "core/particles.hpp"
#include "run/run_settings.hpp"

namespace tektite {

/// Follows material points: each probe stays with the particle that was nearest to its place at the start. Or the
/// extremes of a body, wherever they are.
class Probes {
 public:
  /// At the start of a run; throws InputError where a probe names no body of the file.
  Probes(const std::vector<Probe>& probes, const Particles& particles);
  /// From saved particles: `state` is what save() put there.
  Probes(const std::vector<Probe>& probes, const std::map<std::string, double>& state);
  void save(std::map<std::string, double>& state) const;

  /// Column names, such as centre.pressure or centre.velocity_x.
  std::vector<std::string> columns(const Particles& particles) const;
  std::vector<double> values(const Particles& particles);

 private:
  struct Followed {
    Probe probe;
    std::int64_t id = 0;
    std::size_t index = 0;  ///< where the particle was last; checked at each use, because particles are sorted
  };
  static void find(Followed& followed, const Particles& particles);
  static void append_extremes(const Probe& probe, Field field, const Particles& particles, std::vector<double>& values);
  std::vector<Followed> followed_;
};

}  // namespace tektite
