// What holds for every impact, on impacts drawn at random: mass, momentum and energy are kept, no observer changes the
// outcome, nor do units, the order of particles and bodies, or threads. The seed of an impact that fails is printed,
// and TEKTITE_SEED gives it back.
#include <fmt/format.h>
#include <omp.h>

#include <catch2/catch.hpp>
#include <cstdlib>
#include <memory>
#include <random>

#include "support/frames.hpp"
#include "support/lattice.hpp"
#include "support/random_step.hpp"

using namespace tektite;
using namespace tektite::test;

namespace {

constexpr int impacts = 8;
constexpr int steps = 40;

/// Rounding differs where coordinates or the order of sums do. One impact after a hundred steps stays below 1e-11
/// (frames.cpp); at random a particle may come to lie where a model changes its branch, which costs some digits more.
constexpr double rounding = 1e-9;

/// The leapfrog keeps energy to the square of the step; the Godunov schemes to round-off.
constexpr double leapfrog_drift = 0.02, godunov_drift = 1e-10;

unsigned first_seed() {
  const char* given = std::getenv("TEKTITE_SEED");
  return given ? static_cast<unsigned>(std::strtoul(given, nullptr, 10)) : std::random_device{}();
}

/// Units in which the numbers of a scene are told: powers of two, so that no digit is lost.
struct Units {
  double length = 1.0, time = 1.0, mass = 1.0;
  double speed() const { return length / time; }
  double density() const { return mass / (length * length * length); }
  double pressure() const { return mass / (length * time * time); }
};

/// Two bodies of random sizes, a random gap apart, that meet at a random speed under a random angle.
struct RandomImpact {
  explicit RandomImpact(unsigned seed) {
    Random random(seed);
    const auto whole = [&](int least, int most) {
      return static_cast<int>(std::floor(random.between(least, most + 1.0)));
    };
    space = std::array{Space::line, Space::plane_strain, Space::plane_stress,
                       Space::solid}[static_cast<std::size_t>(whole(0, 3))];
    std::vector<std::string> schemes{"type = 'eulerian'", "type = 'godunov-pm'", "type = 'godunov-split'"};
    if (space != Space::plane_stress) schemes.emplace_back("type = 'total-lagrangian'");
    scheme = schemes[static_cast<std::size_t>(whole(0, static_cast<int>(schemes.size()) - 1))];
    contact = scheme.find("lagrangian") != std::string::npos || whole(0, 1) == 1;
    smoothing = random.between(1.2, 1.6);
    const auto dimensions = static_cast<std::size_t>(dimensions_of(space));
    const int most = dimensions == 1 ? 40 : dimensions == 2 ? 16 : 7;
    for (auto* lattice : {&first, &second}) {
      lattice->spacing = spacing;
      lattice->ratio = smoothing;
      for (std::size_t k = 0; k < dimensions; ++k) {
        lattice->count.push_back(whole(3, most));
        lattice->velocity.push_back(random.between(-400.0, 400.0));
        lattice->first.push_back(-0.5 * (lattice->count[k] - 1) * spacing + random.between(-0.5, 0.5) * spacing);
      }
    }
    first.body = "first";
    second.body = "second";
    first.material = "metal";
    second.material = "plate";
    first.velocity[0] = random.between(300.0, 1500.0);
    first.first[0] = -first.count[0] * spacing;
    second.first[0] = random.between(0.2, 1.0) * spacing;
    second.velocity[0] = random.between(-400.0, 0.0);
  }

  std::string scene(const Units& units = {}) const {
    const auto speed = [&](double value) { return value * units.speed(); };
    const auto pressure = [&](double value) { return value * units.pressure(); };
    const double density = 2785.0 * units.density();
    return fmt::format(
        "time.end = {}\nscheme = {{ {} }}\nsmoothing.ratio = {}\n{}"
        "[material.metal]\ndensity = {}\n"
        "eos = {{ model = 'stiffened-gas', bulk_sound_speed = {}, grueneisen = 2.0 }}\n"
        "strength = {{ model = 'perfectly-plastic', shear_modulus = {}, yield_stress = {} }}\n"
        "[material.plate]\ndensity = {}\n"
        "eos = {{ model = 'mie-grueneisen', bulk_sound_speed = {}, hugoniot_slope = 1.338, grueneisen = 2.0 }}\n"
        "strength = {{ model = 'johnson-cook', shear_modulus = {}, a = {}, b = {}, n = 0.34, c = 0.015, m = 1.0, "
        "reference_rate = {}, melting_temperature = 775.0, specific_heat = {} }}\n",
        1e-3 * units.time, scheme, smoothing, contact ? "contact.model = 'kernel-penalty'\n" : "", density,
        speed(5328.0), pressure(27.6e9), pressure(0.3e9), density, speed(5328.0), pressure(27.6e9), pressure(265e6),
        pressure(426e6), 1.0 / units.time, 875.0 * units.speed() * units.speed());
  }

  Particles particles(const Units& units = {}) const {
    auto p = particles_on(space, {first, second}, 2785.0);
    const double across = std::pow(units.length, 3 - p.dimensions());  // masses are per length or area
    for (auto& x : p.reals(Field::position)) x *= units.length;
    for (auto& h : p.reals(Field::smoothing_length)) h *= units.length;
    for (auto& v : p.reals(Field::velocity)) v *= units.speed();
    for (auto& m : p.reals(Field::mass)) m *= units.mass / across;
    for (auto& rho : p.reals(Field::density)) rho *= units.density();
    return rescaled_bodies(std::move(p), units.length);
  }

  /// The same with the bodies told the other way round, and each body's particles backwards.
  Particles reversed() const {
    auto p = particles_on(space, {second, first}, 2785.0);
    std::vector<std::uint32_t> order;
    for (const auto& body : p.bodies())
      for (std::size_t i = body.range.end; i-- > body.range.begin;) order.push_back(static_cast<std::uint32_t>(i));
    p.permute(order);
    // Ids tell who is who in the order of particles().
    const auto before = particles();
    auto ids = p.integers(Field::id);
    const auto shift = static_cast<std::int64_t>(before.bodies()[0].range.size());
    const auto behind = static_cast<std::int64_t>(p.bodies()[0].range.size());
    for (auto& id : ids) id = id < behind ? id + shift : id - behind;
    return p;
  }

  static constexpr double spacing = 0x1p-10;  // m
  Space space = Space::line;
  std::string scheme;
  bool contact = false;
  double smoothing = 0.0;
  Lattice first, second;

 private:
  /// Spacings of bodies stand beside the fields.
  static Particles rescaled_bodies(Particles p, double length) {
    auto bodies = p.bodies();
    for (auto& body : bodies) body.spacing *= length;
    Particles scaled(p.space(), bodies);
    for (const auto& row : field_table) {
      if (!p.has(row.field)) continue;
      scaled.allocate(row.field);
      if (row.rank == Rank::integer)
        std::ranges::copy(p.integers(row.field), scaled.integers(row.field).begin());
      else
        std::ranges::copy(p.reals(row.field), scaled.reals(row.field).begin());
    }
    return scaled;
  }
};

/// Made where it stays: a scheme holds on to the particles of its simulation.
std::unique_ptr<Simulation> computed(const RandomImpact& impact, Particles particles, const Units& units = {}) {
  std::unique_ptr<Simulation> simulation(new Simulation(simulation_of(impact.scene(units), std::move(particles))));
  take_steps(*simulation, steps);
  return simulation;
}

/// Runs a check on random impacts, each told by its seed.
template <class Check>
void on_random_impacts(const Check& check) {
  const unsigned seed = first_seed();
  for (unsigned k = 0; k < impacts; ++k) {
    const RandomImpact impact(seed + k);
    INFO("TEKTITE_SEED=" << seed + k << ": " << name_of(impact.space) << ", " << impact.scheme
                         << (impact.contact ? ", contact" : ""));
    check(impact);
  }
}

/// The fields of `b`, whose places and velocities are brought back by `back`, are those of `a`.
template <class Back>
void check_same(const Simulation& a, const Simulation& b, const Back& back) {
  const auto &p = a.particles(), &q = b.particles();
  CHECK(b.time() == Approx(a.time()).epsilon(rounding));
  CHECK(difference(by_id(p, Field::position), back(Field::position, by_id(q, Field::position)), RandomImpact::spacing) <
        rounding);
  CHECK(difference(by_id(p, Field::velocity), back(Field::velocity, by_id(q, Field::velocity)), 1500.0) < rounding);
  CHECK(difference(by_id(p, Field::pressure), by_id(q, Field::pressure), 1e10) < rounding);
  CHECK(difference(by_id(p, Field::plastic_strain), by_id(q, Field::plastic_strain), 1.0) < rounding);
}

const auto as_it_is = [](Field, std::vector<double> values) { return values; };

template <int D>
void check_turned(const RandomImpact& impact, const Turn& there, const Turn& back) {
  auto particles = impact.particles();
  for (const auto field : {Field::position, Field::velocity})
    for (std::size_t i = 0; i < particles.count(); ++i)
      particles.vectors<D>(field)[i] = turned<D>(there, particles.vectors<D>(field)[i]);
  check_same(*computed(impact, impact.particles()), *computed(impact, std::move(particles)),
             [&](Field, std::vector<double> values) { return turned_vectors<D>(back, std::move(values)); });
}

}  // namespace

TEST_CASE("Random impacts: mass, momentum and energy are kept", "[random]") {
  on_random_impacts([](const RandomImpact& impact) {
    const auto before = by_id(impact.particles(), Field::mass);
    const auto simulation = computed(impact, impact.particles());
    CHECK(simulation->contact_time());  // an impact it was; thin bodies may have flown apart again
    CHECK(by_id(simulation->particles(), Field::mass) == before);
    const auto ledger = simulation->ledger();
    CHECK(simulation->momentum_drift(ledger) < 1e-12);
    const bool godunov = impact.scheme.find("godunov") != std::string::npos;
    CHECK(std::abs(simulation->energy_drift(ledger)) < (godunov && !impact.contact ? godunov_drift : leapfrog_drift));
    // Plastic and viscous work are parts of the internal energy, and never given back.
    CHECK(ledger.plastic >= 0.0);
    CHECK(ledger.viscous >= 0.0);
  });
}

TEST_CASE("Random impacts: a moving observer sees the same", "[random]") {
  on_random_impacts([](const RandomImpact& impact) {
    const auto width = static_cast<std::size_t>(dimensions_of(impact.space));
    const std::array drift{700.0, -900.0, 300.0};
    auto particles = impact.particles();
    auto velocity = particles.reals(Field::velocity);
    for (std::size_t n = 0; n < velocity.size(); ++n) velocity[n] += drift[n % width];
    const auto moving = computed(impact, std::move(particles));
    check_same(*computed(impact, impact.particles()), *moving, [&](Field field, std::vector<double> values) {
      for (std::size_t n = 0; n < values.size(); ++n)
        values[n] -= drift[n % width] * (field == Field::position ? moving->time() : 1.0);
      return values;
    });
  });
}

TEST_CASE("Random impacts: mirrored and turned ones are the mirrored and turned outcome", "[random]") {
  constexpr Turn back_about_z{{1, 0, 2}, {1.0, -1.0, 1.0}}, back_cyclic{{2, 0, 1}, {1.0, 1.0, 1.0}};
  on_random_impacts([&](const RandomImpact& impact) {
    switch (dimensions_of(impact.space)) {
      case 1:
        return check_turned<1>(impact, mirror_x, mirror_x);
      case 2:
        check_turned<2>(impact, mirror_x, mirror_x);
        return check_turned<2>(impact, quarter_about_z, back_about_z);
      default:
        check_turned<3>(impact, mirror_x, mirror_x);
        return check_turned<3>(impact, cyclic, back_cyclic);
    }
  });
}

TEST_CASE("Random impacts: in other units the numbers are others and the outcome is the same", "[random]") {
  const Units units{0x1p7, 0x1p-4, 0x1p11};
  on_random_impacts([&](const RandomImpact& impact) {
    const auto a = computed(impact, impact.particles()), b = computed(impact, impact.particles(units), units);
    const auto compare = [&](Field field, double unit, double scale) {
      auto values = by_id(b->particles(), field);
      for (auto& value : values) value /= unit;
      INFO(info(field).name);
      CHECK(difference(by_id(a->particles(), field), values, scale) < rounding);
    };
    CHECK(b->time() == Approx(units.time * a->time()).epsilon(rounding));
    compare(Field::position, units.length, RandomImpact::spacing);
    compare(Field::velocity, units.speed(), 1500.0);
    compare(Field::pressure, units.pressure(), 1e10);
    compare(Field::plastic_strain, 1.0, 1.0);
  });
}

TEST_CASE("Random impacts: the order of particles and of bodies does not matter", "[random]") {
  on_random_impacts([](const RandomImpact& impact) {
    check_same(*computed(impact, impact.particles()), *computed(impact, impact.reversed()), as_it_is);
  });
}

TEST_CASE("Random impacts: one thread and two give the same bits", "[random]") {
  on_random_impacts([](const RandomImpact& impact) {
    const int before = omp_get_max_threads();
    omp_set_num_threads(1);
    const auto one = computed(impact, impact.particles());
    omp_set_num_threads(2);
    const auto two = computed(impact, impact.particles());
    omp_set_num_threads(before);
    CHECK(one->time() == two->time());
    for (const auto field : {Field::position, Field::velocity, Field::pressure, Field::plastic_strain})
      CHECK(by_id(one->particles(), field) == by_id(two->particles(), field));
  });
}
