#pragma once

#include <cstdint>
#include <map>
#include <string>
#include <vector>

#include "core/particles.hpp"
#include "run/run_settings.hpp"

namespace tektite {

/// Particles tie for nearest to a probe's place where their distances differ by less than this part of the spacing: far
/// more than rounding makes of a scene that is mirrored, rotated or shifted, far less than what sets particles apart.
inline constexpr double tie_tolerance = 1e-6;

/// Follows material points: each probe shows the mean over the particles that were nearest to its place at the start,
/// mostly one. Or the extremes of a body, wherever they are. Every rank follows them, and has the same values.
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
  /// A line for each probe that tells which particles it follows, and how far from its place they are in `particles`.
  std::vector<std::string> in_words(const Particles& particles);

 private:
  struct Follower {
    std::int64_t id = 0;
    std::size_t index = 0;  ///< where the particle was last; checked at each use, because particles are sorted
  };
  struct Followed {
    Probe probe;
    std::vector<Follower> particles;  ///< in the order of their ids; none of an extreme
  };
  /// Looks for the particle of a probe; whether this rank owns it.
  static bool find(Follower& particle, const Particles& particles);
  /// values(index) of each particle of a probe, from the ranks that own them: `width` numbers each.
  template <class Values>
  static std::vector<double> values_of_each(Followed& followed, const Particles& particles, std::size_t width,
                                            const Values& values);
  static void append_means(Followed& followed, Field field, const Particles& particles, std::vector<double>& values);
  static void append_extremes(const Probe& probe, Field field, const Particles& particles, std::vector<double>& values);
  std::vector<Followed> followed_;
};

}  // namespace tektite
