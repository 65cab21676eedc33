#include "run/simulation.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

#include "boundary/walls.hpp"
#include "core/saved_number.hpp"
#include "output/progress.hpp"
#include "run/angular_momentum.hpp"

namespace tektite {
namespace {

/// A time step may grow by this factor from one step to the next; it may fall at once.
constexpr double growth = 1.1;

/// A total energy at the start below this part of what is at play later is no measure of it: compressed particles
/// without an internal energy start from none.
constexpr double next_to_nothing = 1e-3;

/// A run whose time step has fallen to this part of its first one does not come to an end any more.
constexpr double collapse = 1e-6;

/// What a scheme makes up of energy feeds on itself when it is so many times what there was at the start.
constexpr double runaway = 10.0;

bool any_clamped(const Particles& particles) {
  return particles.has(Field::clamped) &&
         std::ranges::any_of(particles.integers(Field::clamped), [](std::int64_t clamped) { return clamped != 0; });
}

}  // namespace

Simulation::Simulation(Snapshot snapshot, RunSettings settings, bool resumed)
    : snapshot_(std::move(snapshot)), settings_(std::move(settings)) {
  auto& particles = snapshot_.particles;
  const auto& state = snapshot_.state;
  scheme_ = make_scheme({particles, profile_, settings_.materials, settings_.scheme, settings_.scene.symmetry});
  time_ = saved_number(state, "time");
  if (resumed) {
    steps_ = static_cast<std::int64_t>(saved_number(state, "step"));
    first_step_number_ = steps_;
    last_.dt = saved_number(state, "dt");
    first_step_ = saved_number(state, "first_step");
    if (state.contains("contact_time")) contact_time_ = saved_number(state, "contact_time");
    initial_energy_ = saved_number(state, "initial_energy");
    largest_energy_ = saved_number(state, "largest_energy");
    momentum_scale_ = saved_number(state, "momentum_scale");
    for (int k = 0; k < particles.dimensions(); ++k)
      initial_momentum_.push_back(saved_number(state, fmt::format("initial_momentum_{}", "xyz"[k])));
    for (const int axis : axes_of_turning(particles.space()))
      initial_angular_momentum_.push_back(saved_number(state, fmt::format("initial_angular_momentum_{}", "xyz"[axis])));
    largest_angular_momentum_ = saved_number(state, "largest_angular_momentum");
    scheme_->restore(state);
    return;
  }
  scheme_->start();
  const auto ledger = scheme_->ledger();
  initial_energy_ = ledger.total();
  note(ledger);
  initial_momentum_ = ledger.momentum;
  initial_angular_momentum_ = angular_momentum_of(particles);
  largest_angular_momentum_ = largest_angular_momentum_of(particles);
  const auto mass = particles.reals(Field::mass);
  momentum_scale_ = std::sqrt(2.0 * std::accumulate(mass.begin(), mass.end(), 0.0) * ledger.kinetic);
  look_for_contact();
}

double Simulation::end() const {
  if (!settings_.from_contact) return settings_.end;
  return contact_time_ ? *contact_time_ + settings_.end : std::numeric_limits<double>::infinity();
}

TimeStep Simulation::choose_step() const {
  auto choice = scheme_->stable_step();
  if (!(choice.dt > 0.0)) {
    if (const auto inverted = inverted_particle())
      throw RunError(
          fmt::format("negative-jacobian: step {}, t = {}: a particle of the reference configuration is turned inside "
                      "out, det F = {:g}; conversion of adaptle before that, or an Eulerian kernel, may mend it\n{}",
                      steps_, shown_time(time_), jacobian_of(*inverted), describe(*inverted)));
    throw RunError(
        fmt::format("step {}, t = {}: the state is no longer sane (a density that is not positive, a sound "
                    "speed that is not real, or a number that is not finite)\n{}",
                    steps_, shown_time(time_), describe(choice.particle)));
  }
  if (last_.dt > 0.0 && choice.dt > growth * last_.dt) {
    choice.dt = growth * last_.dt;
    choice.reason = StepLimit::growth;
  }
  if (choice.dt < collapse * first_step_)
    throw RunError(
        fmt::format("dt-collapse: step {}, t = {}: the time step has collapsed to {} ({}), {:g} of the first one\n{}",
                    steps_, shown_time(time_), shown_time(choice.dt), name_of(choice.reason), choice.dt / first_step_,
                    describe(choice.particle)));
  if (time_ + choice.dt >= end()) {
    choice.dt = end() - time_;
    choice.reason = StepLimit::end;
  }
  return choice;
}

double Simulation::jacobian_of(std::size_t i) const {
  const auto& p = snapshot_.particles;
  return p.scalars(Field::mass)[i] / (p.scalars(Field::reference_volume)[i] * p.scalars(Field::density)[i]);
}

std::optional<std::size_t> Simulation::inverted_particle() const {
  const auto& p = snapshot_.particles;
  if (!p.has(Field::reference_position)) return std::nullopt;
  for (std::size_t i = 0; i < p.count(); ++i)
    if (jacobian_of(i) < 0.0) return i;
  return std::nullopt;
}

void Simulation::step() {
  {
    const auto scope = profile_.time("time step");
    last_ = choose_step();
    limiting_ = particles().integers(Field::id)[last_.particle];
  }
  if (first_step_ == 0.0) first_step_ = last_.dt;
  scheme_->step(last_.dt);
  time_ = last_.reason == StepLimit::end ? end() : time_ + last_.dt;
  ++steps_;
  look_for_contact();
}

void Simulation::look_for_contact() {
  if (contact_time_ || snapshot_.particles.bodies().size() < 2) return;
  const auto scope = profile_.time("contact");
  if (scheme_->in_contact()) {
    contact_time_ = time_;
  } else if (settings_.from_contact && time_ >= settings_.end) {
    throw RunError(
        fmt::format("t = {}: the run counts from the first contact of two bodies (time.from), but none has come "
                    "in as long a time as was to be computed after it",
                    shown_time(time_)));
  }
}

double Simulation::energy_drift(const Ledger& now) const {
  const double largest = std::max(largest_energy_, now.at_play());
  const double scale = std::abs(initial_energy_) < next_to_nothing * largest ? largest : initial_energy_;
  return scale == 0.0 ? 0.0 : (now.total() - initial_energy_) / scale;
}

void Simulation::note(const Ledger& line) {
  largest_energy_ = std::max(largest_energy_, line.at_play());
  const double made_up = line.total() - initial_energy_;
  // What starts from next to nothing may exchange far more than that, and errs by a part of it; what pulls at a body by
  // clamped particles that move does work on it.
  if (initial_energy_ > 0.0 && made_up > runaway * initial_energy_ && made_up > 0.5 * line.at_play() &&
      !any_clamped(particles()))
    throw RunError(
        fmt::format("energy-runaway: step {}, t = {}: the scheme has made up {:.1f} times the energy of the start; a "
                    "smaller scheme.courant, more viscosity, a finer spacing or another scheme may mend it",
                    steps_, shown_time(time_), made_up / initial_energy_));
}

double Simulation::momentum_drift(const Ledger& now) const {
  if (any_clamped(particles())) return 0.0;
  const auto walls = walls_of(settings_.scene.symmetry, settings_.scheme.anvil);
  double square = 0.0;
  for (std::size_t k = 0; k < initial_momentum_.size(); ++k) {
    const auto across = [axis = static_cast<int>(k)](const SymmetryPlane& wall) { return wall.axis == axis; };
    if (std::ranges::any_of(walls, across)) continue;
    const double change = now.momentum[k] - initial_momentum_[k];
    square += change * change;
  }
  return momentum_scale_ == 0.0 ? std::sqrt(square) : std::sqrt(square) / momentum_scale_;
}

std::optional<double> Simulation::angular_momentum_drift() const {
  if (any_clamped(particles())) return std::nullopt;
  const auto walls = walls_of(settings_.scene.symmetry, settings_.scheme.anvil);
  const auto now = angular_momentum_of(particles());
  const auto axes = axes_of_turning(particles().space());
  std::optional<double> square;
  for (std::size_t k = 0; k < axes.size(); ++k) {
    const auto across = [axis = axes[k]](const SymmetryPlane& wall) { return wall.axis == axis; };
    if (!std::ranges::all_of(walls, across)) continue;
    const double change = now[k] - initial_angular_momentum_[k];
    square = square.value_or(0.0) + change * change;
  }
  if (!square) return std::nullopt;
  const double scale = std::max(largest_angular_momentum_, largest_angular_momentum_of(particles()));
  return scale == 0.0 ? 0.0 : std::sqrt(*square) / scale;
}

std::string Simulation::describe(std::size_t i) const {
  const auto& particles = snapshot_.particles;
  std::string text = fmt::format("  particle {}", particles.integers(Field::id)[i]);
  for (const auto& body : particles.bodies())
    if (i >= body.range.begin && i < body.range.end) text += fmt::format(" of {} ({})", body.name, body.material);
  for (const auto& row : field_table) {
    if (!particles.has(row.field) || row.keep == Keep::scratch || row.rank == Rank::integer) continue;
    const auto width = static_cast<std::size_t>(particles.components(row.field));
    const auto values = particles.reals(row.field).subspan(i * width, width);
    text += fmt::format("\n    {} = {:g} {}", row.name, fmt::join(values, " "), row.unit);
  }
  return text;
}

const Snapshot& Simulation::save(const std::map<std::string, double>& others) {
  auto& state = snapshot_.state;
  for (const auto& [name, value] : others) state[name] = value;
  state["time"] = time_;
  state["step"] = static_cast<double>(steps_);
  state["dt"] = last_.dt;
  state["first_step"] = first_step_;
  if (contact_time_) state["contact_time"] = *contact_time_;
  state["initial_energy"] = initial_energy_;
  state["largest_energy"] = largest_energy_;
  state["momentum_scale"] = momentum_scale_;
  for (std::size_t k = 0; k < initial_momentum_.size(); ++k)
    state[fmt::format("initial_momentum_{}", "xyz"[k])] = initial_momentum_[k];
  const auto axes = axes_of_turning(snapshot_.particles.space());
  for (std::size_t k = 0; k < axes.size(); ++k)
    state[fmt::format("initial_angular_momentum_{}", "xyz"[axes[k]])] = initial_angular_momentum_[k];
  state["largest_angular_momentum"] = largest_angular_momentum_;
  scheme_->save(state);
  return snapshot_;
}

}  // namespace tektite
