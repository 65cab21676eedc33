#include "run/simulation.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <chrono>
#include <cmath>
#include <limits>

#include "boundary/walls.hpp"
#include "core/saved_number.hpp"
#include "output/progress.hpp"
#include "parallel/agreed.hpp"
#include "parallel/reduce.hpp"
#include "parallel/sums.hpp"
#include "run/angular_momentum.hpp"
#include "schemes/state_sums.hpp"

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
  if (!particles.has(Field::clamped)) return false;
  return any_over(particles, {0, particles.count()},
                  [clamped = particles.integers(Field::clamped)](std::size_t i) { return clamped[i] != 0; });
}

}  // namespace

Simulation::Simulation(Snapshot snapshot, RunSettings settings, bool resumed)
    : snapshot_(std::move(snapshot)), settings_(std::move(settings)) {
  auto& state = snapshot_.state;
  time_ = saved_number(state, "time");
  if (ranks() > 1) distribution_.emplace(settings_.scene.symmetry);
  build_scheme();
  if (distribution_) deal(resumed ? state : std::map<std::string, double>());
  clamped_ = any_clamped(particles());
  if (resumed) {
    restore(state);
    scheme_->restore(state);
    return;
  }
  scheme_->start();
  note_start();
  look_for_contact();
  if (distribution_) deal_again();  // start() has ordered the particles
}

void Simulation::build_scheme() {
  SchemeSetup setup{snapshot_.particles, profile_, settings_.materials, settings_.scheme, settings_.scene.symmetry};
  if (distribution_) setup.refresh = [this](Field field) { distribution_->refresh(snapshot_.particles, field); };
  scheme_ = make_scheme(setup);
}

void Simulation::restore(const std::map<std::string, double>& state) {
  const auto& particles = snapshot_.particles;
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
}

void Simulation::note_start() {
  const auto& particles = snapshot_.particles;
  const auto ledger = scheme_->ledger();
  initial_energy_ = ledger.total();
  note(ledger);
  initial_momentum_ = ledger.momentum;
  initial_angular_momentum_ = angular_momentum();
  largest_angular_momentum_ = largest_angular_momentum_of(particles);
  const auto mass =
      sum_over<1>(particles, [m = particles.scalars(Field::mass)](std::size_t i) { return std::array{m[i]}; })[0];
  momentum_scale_ = std::sqrt(2.0 * mass * ledger.kinetic);
}

void Simulation::deal(const std::map<std::string, double>& state) {
  const auto halos = scheme_->halos(state);
  scheme_.reset();
  distribution_->deal(snapshot_.particles, halos);
  build_scheme();
}

void Simulation::deal_again() {
  scheme_->save(snapshot_.state);
  deal(snapshot_.state);
  scheme_->restore(snapshot_.state);
}

double Simulation::end() const {
  if (!settings_.from_contact) return settings_.end;
  return contact_time_ ? *contact_time_ + settings_.end : std::numeric_limits<double>::infinity();
}

TimeStep Simulation::choose_step() const {
  auto choice = scheme_->stable_step();
  if (!(choice.dt > 0.0)) {
    if (const auto inverted = inverted_particle()) {
      const auto determinant =
          told_by_owner(*inverted, [this](std::size_t i) { return fmt::format("{:g}", jacobian_of(i)); });
      throw RunError(
          fmt::format("negative-jacobian: step {}, t = {}: a particle of the reference configuration is turned inside "
                      "out, det F = {}; conversion of adaptle before that, or an Eulerian kernel, may mend it\n{}",
                      steps_, shown_time(time_), determinant, describe(*inverted)));
    }
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

std::optional<std::int64_t> Simulation::inverted_particle() const {
  const auto& p = snapshot_.particles;
  if (!p.has(Field::reference_position)) return std::nullopt;
  constexpr auto none = std::numeric_limits<std::int64_t>::max();
  const auto join = [](std::int64_t& whole, std::int64_t part) { whole = std::min(whole, part); };
  const auto least = reduce(
      p, none,
      [&](std::int64_t& id, std::size_t i) {
        if (jacobian_of(i) < 0.0) join(id, p.integers(Field::id)[i]);
      },
      join);
  return least == none ? std::nullopt : std::optional(least);
}

template <class What>
std::string Simulation::told_by_owner(std::int64_t particle, const What& what) const {
  const auto& p = snapshot_.particles;
  const auto id = p.integers(Field::id);
  const auto i = static_cast<std::size_t>(std::ranges::find(id, particle) - id.begin());
  const bool own = i < p.count() && Owned(p)(i);
  const auto text = own ? what(i) : std::string();
  return distribution_ ? text_of_all(text) : text;
}

void Simulation::step() {
  {
    const auto scope = profile_.time("time step");
    last_ = choose_step();
  }
  if (first_step_ == 0.0) first_step_ = last_.dt;
  if (distribution_)
    step_with_others();
  else
    scheme_->step(last_.dt);
  time_ = last_.reason == StepLimit::end ? end() : time_ + last_.dt;
  ++steps_;
  look_for_contact();
  if (distribution_ && scheme_->search_is_left()) search(0.0);
}

/// Of several ranks: begins a search for a step of dt, and goes on from it.
void Simulation::search(double dt) {
  const auto scope = profile_.time("dealing");
  scheme_->begin_search(dt);
  deal_again();
}

void Simulation::step_with_others() {
  touched_ = false;
  for (int part = 0; part < scheme_->parts(); ++part) {
    const double ahead = part == 0 ? last_.dt : 0.0;
    if (part > 0) touched_ = scheme_->in_contact();
    if (scheme_->search_is_due(ahead)) search(ahead);
    using Clock = std::chrono::steady_clock;
    const auto start = Clock::now();
    scheme_->step_part(part, last_.dt);
    distribution_->note_step(std::chrono::duration<double>(Clock::now() - start).count());
    const auto scope = profile_.time("exchange");
    distribution_->refresh(snapshot_.particles);
  }
}

void Simulation::look_for_contact() {
  if (contact_time_ || snapshot_.particles.bodies().size() < 2) return;
  const auto scope = profile_.time("contact");
  if (touched_ || scheme_->in_contact()) {
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
  if (initial_energy_ > 0.0 && made_up > runaway * initial_energy_ && made_up > 0.5 * line.at_play() && !clamped_)
    throw RunError(
        fmt::format("energy-runaway: step {}, t = {}: the scheme has made up {:.1f} times the energy of the start; a "
                    "smaller scheme.courant, more viscosity, a finer spacing or another scheme may mend it",
                    steps_, shown_time(time_), made_up / initial_energy_));
}

double Simulation::momentum_drift(const Ledger& now) const {
  if (clamped_) return 0.0;
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
  if (clamped_) return std::nullopt;
  const auto walls = walls_of(settings_.scene.symmetry, settings_.scheme.anvil);
  const auto now = AngularMomentum()(particles());
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

std::string Simulation::describe(std::int64_t particle) const {
  return told_by_owner(particle, [this, particle](std::size_t i) {
    const auto& particles = snapshot_.particles;
    std::string text = fmt::format("  particle {}", particle);
    for (const auto& body : particles.bodies())
      if (i >= body.range.begin && i < body.range.end) text += fmt::format(" of {} ({})", body.name, body.material);
    for (const auto& row : field_table) {
      if (!particles.has(row.field) || !saved(row.keep) || row.rank == Rank::integer) continue;
      const auto width = static_cast<std::size_t>(particles.components(row.field));
      const auto values = particles.reals(row.field).subspan(i * width, width);
      text += fmt::format("\n    {} = {:g} {}", row.name, fmt::join(values, " "), row.unit);
    }
    return text;
  });
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

void Simulation::look(const std::function<void(const Particles&)>& look) const {
  if (!distribution_) return look(particles());
  double width = 2.0 * smoothing_range(particles()).second;
  for (const auto& body : particles().bodies()) width = std::max(width, 2.0 * body.spacing);
  Halos halos{{width, Field::position}};
  if (particles().has(Field::reference_position)) halos.push_back({width, Field::reference_position});
  look(distribution_->with_copies(particles(), halos));
}

std::vector<double> Simulation::angular_momentum() { return angular_momentum_(particles()); }

}  // namespace tektite
