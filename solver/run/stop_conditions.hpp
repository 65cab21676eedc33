#pragma once
// What ends a run before its time: [stop_when.NAME] of a scene. Conditions are looked at with every line of
// history.csv, from the first contact on where there are several bodies. They are functions of the particles and of
// that line alone, so the number of threads and restarts do not change when a run stops.

#include <array>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "core/document.hpp"
#include "core/particles.hpp"

namespace tektite {

struct StopCondition {
  enum class Type { perforated, rebounded, kinetic_energy_steady, steady, passes };
  std::string name;
  Type type = Type::steady;
  std::string projectile, body;  ///< of perforated and rebounded
  std::string column;            ///< of history.csv; of the others
  double tolerance = 0.0;        ///< of the column's largest magnitude so far
  double during = 0.0;           ///< s
  double value = 0.0;            ///< in the column's unit, to be passed
};

/// Reads all [stop_when.NAME]. Throws InputError.
std::vector<StopCondition> read_stop_conditions(Section& root, const std::vector<std::string>& bodies);

/// Throws InputError where a condition's projectile does not move against its body, or where history.csv has not its
/// column.
void check_stop_conditions(Document& document, const std::vector<StopCondition>& conditions, const Particles& particles,
                           const std::vector<std::string>& columns);

/// Whether a projectile has passed a body or come back from it. All is measured between the centres of mass of both,
/// along the direction in which the projectile moves against the body at the start, so no observer changes it.
class Passage {
 public:
  Passage(const StopCondition& condition, const Particles& start);
  Passage(const StopCondition& condition, const std::map<std::string, double>& state);
  void save(const StopCondition& condition, std::map<std::string, double>& state) const;

  /// The projectile's centre is behind the body's rear face by the projectile's length.
  bool perforated(const StopCondition& condition, const Particles& particles) const;
  /// It moves back, and its centre is before the body's front face by half its length, where it was when it struck.
  bool rebounded(const StopCondition& condition, const Particles& particles) const;

 private:
  std::array<double, 3> direction_{};  ///< a unit vector
  double front_ = 0.0, rear_ = 0.0;    ///< faces of the body at the start, from its centre, m
  double length_ = 0.0;                ///< of the projectile at the start, m
};

/// For how long a value has stayed near one value.
class Steadiness {
 public:
  void save(const StopCondition& condition, std::map<std::string, double>& state) const;
  void restore(const StopCondition& condition, const std::map<std::string, double>& state);
  /// Takes the value in; true where it has been within the tolerance of the value at some time for as long as asked.
  bool steady(const StopCondition& condition, double time, double value);

 private:
  std::optional<double> since_;
  double value_ = 0.0;    ///< at `since_`
  double largest_ = 0.0;  ///< magnitude
};

/// Whether a value has come to another one, from the side on which it was at first.
class Crossing {
 public:
  void save(const StopCondition& condition, std::map<std::string, double>& state) const;
  void restore(const StopCondition& condition, const std::map<std::string, double>& state);
  bool passed(const StopCondition& condition, double value);

 private:
  double side_ = 0.0;  ///< 1 above, -1 below, 0 as long as it has been nowhere else
};

class StopConditions {
 public:
  /// `columns` are those of the numbers that look() is given.
  StopConditions(const std::vector<StopCondition>& conditions, const Particles& start,
                 const std::vector<std::string>& columns);
  /// From saved particles: `state` is what save() put there.
  StopConditions(const std::vector<StopCondition>& conditions, const std::map<std::string, double>& state,
                 const std::vector<std::string>& columns);
  void save(std::map<std::string, double>& state) const;

  void look(double time, const Particles& particles, const std::vector<double>& numbers);
  /// The first condition that is met; nullptr while there is none.
  const StopCondition* met() const { return met_ < watches_.size() ? &watches_[met_].condition : nullptr; }

 private:
  struct Watch {
    StopCondition condition;
    std::optional<Passage> passage;
    Steadiness steadiness;
    Crossing crossing;
    std::size_t column = 0;
  };
  static bool holds(Watch& watch, double time, const Particles& particles, const std::vector<double>& numbers);
  void find_columns(const std::vector<std::string>& columns);
  std::vector<Watch> watches_;
  std::size_t met_ = 0;
};

/// What it means that a condition is met.
std::string in_words(const StopCondition& condition);

}  // namespace tektite
