// Eulerian sums with the mixed correction: exact for linear fields on any arrangement, up to the boundary; the switch;
// momentum and angular momentum.
#include "passes/corrected_rates.hpp"

#include <catch2/catch.hpp>
#include <random>

#include "physics/kernels/kernel.hpp"
#include "physics/viscosity/viscosity.hpp"
#include "schemes/mixed_correction.hpp"

using namespace tektite;

namespace {

template <int D>
struct Block {
  static constexpr int side = D == 3 ? 6 : 9;
  std::vector<Vector<double, D>> places;
  std::vector<CorrectedRecord<D>> records;
  PairList pairs;
  Mirror<D> mirror{{}};
  std::vector<Vector<double, D>> acceleration;
  std::vector<Tensor<double, D>> gradient;
  std::vector<double> power, signal;
  std::mt19937 random{D};

  /// Disordered by a fifth of the spacing, with disordered masses, velocities and stresses.
  Block() {
    std::uniform_real_distribution<double> jitter(-0.2, 0.2), unit(-1.0, 1.0);
    std::size_t count = 1;
    for (int k = 0; k < D; ++k) count *= side;
    for (std::size_t i = 0; i < count; ++i) {
      CorrectedRecord<D> r{};
      for (std::size_t k = 0, rest = i; k < D; ++k, rest /= side) {
        r.x[static_cast<int>(k)] = static_cast<double>(rest % side) + jitter(random);
        r.v[static_cast<int>(k)] = unit(random);
      }
      for (auto& s : r.stress) s = unit(random);
      for (auto& s : r.artificial) s = unit(random);
      r.volume = 1.0 + jitter(random);
      r.density = 1.5 + jitter(random);
      r.sound_speed = 1.0;
      r.smoothing_length = 1.4;
      r.spacing = 1.0;
      r.eulerian = r.pushes = 1.0;
      r.correction = Correction<double, D>::none();
      places.push_back(r.x);
      records.push_back(r);
    }
    CellGrid<D> grid;
    grid.build(places, 2.8);
    const std::vector<std::uint32_t> body(count, 0);
    pairs.build<D>(grid, places, count, 2.8, Pairing::all, body);
    REQUIRE(MixedCorrection<CubicSpline, D>(least_moment_of_pieces<D>).find(pairs, mirror, records, count) == 0);
  }

  template <bool artificial>
  void evaluate(double limit, const MonaghanViscosity& viscosity) {
    const auto count = records.size();
    acceleration.resize(count);
    gradient.resize(count);
    power.resize(count);
    signal.resize(count);
    for_each_pair(
        pairs,
        CorrectedRates<CubicSpline, MonaghanViscosity, D, true, artificial>{
            records.data(), viscosity, {limit}, 4, acceleration.data(), gradient.data(), power.data(), signal.data()});
  }
};

constexpr double no_limit = std::numeric_limits<double>::infinity();

template <int D>
void check_linear_velocity() {
  Block<D> block;
  Tensor<double, D> l;
  for (int k = 0; k < D * D; ++k) l.c[k] = 0.3 * k - 0.7;
  for (auto& r : block.records) r.v = times(l, r.x);
  block.template evaluate<false>(no_limit, {0.0, 0.0});
  for (const auto& gradient : block.gradient)
    for (int k = 0; k < D * D; ++k) CHECK(gradient.c[k] == Approx(l.c[k]).margin(1e-11));
}

template <int D, bool artificial>
void check_conservation(double limit) {
  Block<D> block;
  block.template evaluate<artificial>(limit, {1.0, 2.0});
  auto force = Vector<double, D>::zero();
  double total_power = 0.0, scale = 0.0;
  for (std::size_t i = 0; i < block.records.size(); ++i) {
    const auto& r = block.records[i];
    const double mass = r.volume * r.density;
    force = force + mass * block.acceleration[i];
    double stress_power = 0.0;
    for (int a = 0; a < D; ++a)
      for (int b = 0; b < D; ++b) stress_power += r.stress[r.index(a, b)] * block.gradient[i](a, b);
    total_power += mass * dot(block.acceleration[i], r.v) + r.volume * stress_power + mass * block.power[i];
    scale += std::abs(r.volume * stress_power);
  }
  for (int k = 0; k < D; ++k) CHECK(force[k] == Approx(0.0).margin(1e-12 * scale));
  CHECK(total_power == Approx(0.0).margin(1e-12 * scale));
}

}  // namespace

TEST_CASE("Mixed correction: a linear velocity field has its gradient, on any arrangement, up to the boundary") {
  check_linear_velocity<1>();
  check_linear_velocity<2>();
  check_linear_velocity<3>();
}

TEST_CASE("Corrected sums: momentum and energy are kept to round-off, also where the switch acts") {
  for (const double limit : {no_limit, 7.5, 1.2}) {
    check_conservation<1, false>(limit);
    check_conservation<2, false>(limit);
    check_conservation<2, true>(limit);
    check_conservation<3, false>(limit);
  }
}

TEST_CASE(
    "Mixed correction: splinters go without and are counted, the reference configuration has what can be inverted") {
  // Rows of particles at h = 1, each but the first by `bend` spacings off the line of those before.
  struct Case {
    int count;
    double bend;
    std::size_t without_of_pieces, without_of_reference;
  };
  for (const auto& [count, bend, of_pieces, of_reference] :
       {Case{2, 0.0, 2, 2}, Case{3, 0.0, 3, 3}, Case{3, 0.3, 3, 0}, Case{3, 1.0, 2, 0}}) {
    INFO(count << " particles, " << bend);
    std::vector<Vector<double, 2>> places;
    std::vector<CorrectedRecord<2>> records(count);
    for (int i = 0; i < count; ++i) {
      records[i].x[0] = std::min(i, 1);
      records[i].x[1] = i > 1 ? bend : 0.0;
      if (i > 1) records[i].x[0] += 1.0 - bend;
      records[i].volume = records[i].smoothing_length = 1.0;
      records[i].correction = Correction<double, 2>::none();
      places.push_back(records[i].x);
    }
    CellGrid<2> grid;
    grid.build(places, 2.0);
    PairList pairs;
    const std::vector<std::uint32_t> body(count, 0);
    pairs.build<2>(grid, places, count, 2.0, Pairing::all, body);
    const Mirror<2> mirror{{}};
    auto reference = records;
    CHECK(MixedCorrection<CubicSpline, 2>(least_moment_of_reference).find(pairs, mirror, reference, count) ==
          of_reference);
    CHECK(MixedCorrection<CubicSpline, 2>(least_moment_of_pieces<2>).find(pairs, mirror, records, count) == of_pieces);
    if (of_pieces < records.size()) continue;
    for (const auto& r : records) {
      CHECK(r.correction.matrix(0, 0) == 1.0);
      CHECK(r.correction.matrix(0, 1) == 0.0);
      CHECK(r.correction.shift[0] == 0.0);
    }
  }
}

TEST_CASE("Correction switch: a factor, a sign, and no question where the pair is level") {
  const auto chosen = [](double corrected_x, double corrected_y, double y) -> double {
    const Vector<Pack, 2> corrected{{Pack(corrected_x), Pack(corrected_y)}}, plain{{Pack(1.0), Pack(1.0)}};
    const Vector<Pack, 2> x{{Pack(1.0), Pack(y)}};
    return CorrectionSwitch{2.0}.choose<2>(corrected, plain, x, Pack(1.0))[0][0];
  };
  CHECK(chosen(1.9, 0.6, 1.0) == 1.9);
  CHECK(chosen(2.1, 1.0, 1.0) == 1.0);
  CHECK(chosen(0.4, 1.0, 1.0) == 1.0);
  CHECK(chosen(-1.0, 1.0, 1.0) == 1.0);
  CHECK(chosen(1.9, 5.0, 1.0) == 1.0);
  CHECK(chosen(1.9, 5.0, 0.0) == 1.9);
}
