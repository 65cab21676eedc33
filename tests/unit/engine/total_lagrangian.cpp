// What the sums of the reference configuration reproduce: with the mixed correction any linear motion, on any
// arrangement, up to the boundary.
#include <catch2/catch.hpp>
#include <cmath>
#include <numbers>
#include <random>

#include "neighbours/reference_pairs.hpp"
#include "parallel/for_each_pair.hpp"
#include "passes/lagrangian_motion.hpp"
#include "passes/lagrangian_sums.hpp"
#include "passes/least_stretch.hpp"
#include "physics/kernels/kernel.hpp"
#include "physics/viscosity/monaghan.hpp"
#include "schemes/mixed_correction.hpp"
#include "support/random_step.hpp"

using namespace tektite;

namespace {

/// A disordered block of 7^D particles at a spacing of one, displaced by up to a fifth of it.
template <int D>
Particles disordered_block() {
  constexpr int side = 7;
  std::size_t count = 1;
  for (int k = 0; k < D; ++k) count *= side;
  constexpr Space space = D == 1 ? Space::line : D == 2 ? Space::plane_strain : Space::solid;
  Particles particles(space, {{"block", "rubber", 1.0, {0, count}}});
  particles.allocate(Field::reference_position);
  std::mt19937 generator(D);
  std::uniform_real_distribution<double> jitter(-0.2, 0.2);
  for (std::size_t i = 0, rest; i < count; ++i) {
    rest = i;
    for (int k = 0; k < D; ++k, rest /= side)
      particles.vectors<D>(Field::reference_position)[i][k] = static_cast<double>(rest % side) + jitter(generator);
  }
  return particles;
}

template <int D>
Tensor<double, D> transposed_product(const Tensor<double, D>& a) {
  auto result = Tensor<double, D>::zero();
  for (int i = 0; i < D; ++i)
    for (int j = 0; j < D; ++j)
      for (int k = 0; k < D; ++k) result(i, j) += a(k, i) * a(k, j);
  return result;
}

/// The reference configuration with its correction, and the deformation that a motion x = A X, v = B X has in it.
template <int D>
class Reference {
 public:
  Reference() : particles_(disordered_block<D>()), mirror_({}) {
    const auto count = particles_.count();
    pairs_ = reference_pairs(ReferencePlaces<D>(particles_, mirror_, 2.8), count, 2.8);
    records_.resize(count);
    for (std::size_t i = 0; i < count; ++i)
      records_[i] = {1.0, particles_.vectors<D>(Field::reference_position)[i], 1.4, 1.0};
    std::vector<CorrectionRecord<D>> corrected;
    for (const auto& r : records_)
      corrected.push_back({r.x, r.volume, r.smoothing_length, Correction<double, D>::none()});
    REQUIRE(MixedCorrection<CubicSpline, D>(least_moment_of_reference).find(pairs_, mirror_, corrected, count) == 0);
    for (const auto& r : corrected) corrections_.push_back(r.correction);
  }

  /// body(F, dF/dt) of every particle.
  template <class Body>
  void move(const Tensor<double, D>& a, const Tensor<double, D>& b, const Body& body) const {
    const auto count = records_.size();
    std::vector<MotionRecord<D>> motion(count);
    std::vector<StressRecord<D>> deformed(count);
    for (std::size_t i = 0; i < count; ++i) motion[i] = {times(a, records_[i].x), times(b, records_[i].x)};
    for_each_pair(pairs_, DeformationSums<CubicSpline, D, true, ListedRecords<D>>{
                              {{records_.data(), motion.data(), nullptr}, records_.data(), corrections_.data()},
                              deformed.data()});
    for (std::size_t i = 0; i < count; ++i) body(deformed[i].cofactor, deformed[i].stress);
  }

  const PairList& pairs() const { return pairs_; }
  const std::vector<ReferenceRecord<D>>& records() const { return records_; }
  const std::vector<Correction<double, D>>& corrections() const { return corrections_; }

 private:
  Particles particles_;
  Mirror<D> mirror_;
  PairList pairs_;
  std::vector<ReferenceRecord<D>> records_;
  std::vector<Correction<double, D>> corrections_;
};

template <int D>
double largest_difference(const Tensor<double, D>& a, const Tensor<double, D>& b) {
  double most = 0.0;
  for (int k = 0; k < D * D; ++k) most = std::max(most, std::abs(a.c[k] - b.c[k]));
  return most;
}

template <int D>
void check_linear_motion() {
  std::mt19937 generator(10 + D);
  std::uniform_real_distribution<double> number(-0.5, 0.5);
  Tensor<double, D> a, b;
  for (int k = 0; k < D * D; ++k) {
    a.c[k] = number(generator);
    b.c[k] = number(generator);
  }
  double most = 0.0;
  Reference<D>().move(a, b, [&](const auto& f, const auto& rate) {
    most = std::max({most, largest_difference(f, a), largest_difference(rate, b)});
  });
  CHECK(most < 1e-12);  // sums of some ten to a hundred numbers of order one
}

/// A random motion with random P and J F⁻ᵀ of every particle of a reference configuration.
template <int D>
struct RandomState {
  std::vector<MotionRecord<D>> motion;
  std::vector<StressRecord<D>> stress;

  explicit RandomState(const std::vector<ReferenceRecord<D>>& reference)
      : motion(reference.size()), stress(reference.size()) {
    test::Random random(20 + D);
    for (std::size_t i = 0; i < reference.size(); ++i) {
      motion[i].x = reference[i].x;
      for (int k = 0; k < D; ++k) motion[i].v[k] = random.between(-1.0, 1.0);
      stress[i] = {random.between(0.9, 1.1), 1.0, random.between(0.5, 1.0), random.gradient<D>(1.0),
                   random.gradient<D>(1.0),  1.0};
      for (int k = 0; k < D; ++k) stress[i].cofactor(k, k) += 1.0;
    }
  }
};

struct Push {
  std::vector<double> acceleration;
  double power;
};

/// Young et al. (2021), eq. 2, of one particle of mass one, neighbour after neighbour as it is printed.
template <int D>
Push push_on(std::size_t a, const std::vector<ReferenceRecord<D>>& reference,
             const std::vector<Correction<double, D>>& corrections, const RandomState<D>& state,
             const MonaghanViscosity& viscosity) {
  const auto& own = reference[a];
  Push push{std::vector<double>(D, 0.0), 0.0};
  for (std::size_t b = 0; b < reference.size(); ++b) {
    const auto apart = own.x - reference[b].x;
    if (a == b || norm(apart) >= 2.8) continue;
    const KernelPair<CubicSpline, D> pair(broadcast(apart), Pack(1.4));
    Vector<double, D> slope, opposite;
    for (int k = 0; k < D; ++k) {
      slope[k] = pair.slope[k][0];
      opposite[k] = -slope[k];
    }
    const auto here = corrections[a].gradient(slope, pair.value[0]);
    const auto there = corrections[b].gradient(opposite, pair.value[0]);
    const auto &mine = state.stress[a], &other = state.stress[b];
    const auto pull = times(other.stress, there) - times(mine.stress, here);
    const auto bracket = times(other.cofactor, there) - times(mine.cofactor, here);
    const auto x = state.motion[a].x - state.motion[b].x, v = state.motion[a].v - state.motion[b].v;
    const double h = 1.4 * 0.5 * (mine.least_stretch + other.least_stretch);
    const double pi = viscosity(dot(v, x), dot(x, x), h, 0.5 * (mine.sound_speed + other.sound_speed),
                                0.5 * (mine.density + other.density))
                          .pi;
    const double power = dot(v, bracket);
    const double damping = power < 0.0 ? own.volume * mine.density * reference[b].volume * other.density * pi : 0.0;
    for (int k = 0; k < D; ++k)
      push.acceleration[static_cast<std::size_t>(k)] +=
          0.5 * damping * bracket[k] - own.volume * reference[b].volume * pull[k];
    push.power -= 0.25 * damping * power;
  }
  return push;
}

template <int D>
void check_forces() {
  Reference<D> block;
  auto reference = block.records();
  test::Random random(30 + D);
  for (auto& record : reference) record.volume = random.between(0.9, 1.1);
  const RandomState<D> state(reference);
  const MonaghanViscosity viscosity{1.0, 2.0};
  auto weighed = state.stress;
  std::vector<ShiftRecord<D>> shift(reference.size());
  const auto count = reference.size();
  for (std::size_t i = 0; i < count; ++i)
    WeighStress<D, true>{reference.data(), block.corrections().data(), weighed.data(), shift.data()}(i);
  const std::vector<double> mass(count, 1.0);
  std::vector<Vector<double, D>> acceleration(count);
  std::vector<double> power(count), signal(count);
  for_each_pair(block.pairs(),
                LagrangianForces<CubicSpline, MonaghanViscosity, D, true, ListedRecords<D>>{
                    {{reference.data(), state.motion.data(), weighed.data(), shift.data()}, reference.data()},
                    viscosity,
                    weighed.data(),
                    shift.data(),
                    mass.data(),
                    acceleration.data(),
                    power.data(),
                    signal.data()});
  double most = 0.0, largest = 0.0;
  for (std::size_t i = 0; i < count; ++i) {
    const auto expected = push_on(i, reference, block.corrections(), state, viscosity);
    for (int k = 0; k < D; ++k) {
      most = std::max(most, std::abs(acceleration[i][k] - expected.acceleration[static_cast<std::size_t>(k)]));
      largest = std::max(largest, std::abs(acceleration[i][k]));
    }
    most = std::max(most, std::abs(power[i] - expected.power));
  }
  CHECK(largest > 1.0);
  CHECK(most < 1e-12 * largest);  // sums of some ten to a hundred numbers in another order
}

}  // namespace

TEST_CASE("Total Lagrangian: forces are the printed sum with corrected gradients", "[lagrangian]") {
  check_forces<2>();
  check_forces<3>();
}

TEST_CASE("Total Lagrangian: a linear motion is reproduced to round-off on a disordered arrangement", "[lagrangian]") {
  check_linear_motion<1>();
  check_linear_motion<2>();
  check_linear_motion<3>();
}

TEST_CASE("Total Lagrangian: a turn by any angle up to 360 degrees strains nothing", "[lagrangian]") {
  const Reference<2> reference;
  for (double angle = 0.0; angle <= 2.0 * std::numbers::pi + 0.1; angle += std::numbers::pi / 6.0) {
    const double c = std::cos(angle), s = std::sin(angle);
    const Tensor<double, 2> turn{{c, -s, s, c}}, spin{{-s, -c, c, -s}};  // R and dR/dt at unit angular speed
    const Tensor<double, 2> unit{{1.0, 0.0, 0.0, 1.0}};
    reference.move(turn, spin, [&](const auto& f, const auto& rate) {
      CHECK(largest_difference(transposed_product(f), unit) < 1e-12);
      CHECK(determinant(f) == Approx(1.0).epsilon(1e-12));
      // L = dF/dt F^-1 is the spin alone
      const auto cof = cofactor(f);
      for (int i = 0; i < 2; ++i) {
        double diagonal = 0.0;
        for (int k = 0; k < 2; ++k) diagonal += rate(i, k) * cof(i, k);
        CHECK(std::abs(diagonal) < 1e-12);
      }
    });
  }
}

TEST_CASE("Total Lagrangian: the cofactor is det(F) times the inverse transposed", "[lagrangian]") {
  const Tensor<double, 3> f{{1.1, 0.2, -0.3, 0.05, 0.9, 0.4, 0.3, -0.1, 1.3}};
  const auto c = cofactor(f);
  for (int i = 0; i < 3; ++i)
    for (int j = 0; j < 3; ++j) {
      double sum = 0.0;
      for (int k = 0; k < 3; ++k) sum += f(i, k) * c(j, k);
      CHECK(sum == Approx(i == j ? determinant(f) : 0.0).margin(1e-14));
    }
}

TEST_CASE("Total Lagrangian: the least stretch is the smallest singular value of F, or a little below in the solid",
          "[lagrangian]") {
  const auto least = []<int D>(const Tensor<double, D>& f) { return least_stretch(cofactor(f), determinant(f)); };
  CHECK(least(Tensor<double, 1>{{0.4}}) == Approx(0.4));
  CHECK(least(Tensor<double, 1>{{1.6}}) == 1.0);
  for (const double angle : {0.0, 0.7, 2.1}) {  // R diag(0.3, 2.5) R'
    const double c = std::cos(angle), s = std::sin(angle);
    const Tensor<double, 2> f{
        {0.3 * c * c + 2.5 * s * s, (0.3 - 2.5) * c * s, (0.3 - 2.5) * c * s, 0.3 * s * s + 2.5 * c * c}};
    CHECK(least(f) == Approx(0.3));
  }
  CHECK(least(Tensor<double, 3>{{0.3, 0.0, 0.0, 0.0, 2.0, 0.0, 0.0, 0.0, 2.0}}) == Approx(0.3).epsilon(0.01));
  const double mixed = least(Tensor<double, 3>{{0.3, 0.0, 0.0, 0.0, 0.4, 0.0, 0.0, 0.0, 2.0}});
  CHECK(mixed <= 0.3);
  CHECK(mixed > 0.25);
}
