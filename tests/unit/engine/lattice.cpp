// Bodies on a lattice: they are found, and their sums are those over lists of neighbours.
#include "neighbours/lattice.hpp"

#include <algorithm>
#include <array>
#include <catch2/catch.hpp>
#include <cmath>
#include <vector>

#include "neighbours/reference_pairs.hpp"
#include "parallel/for_each_pair.hpp"
#include "physics/kernels/kernel.hpp"
#include "physics/viscosity/monaghan.hpp"
#include "schemes/lattice_bodies.hpp"
#include "schemes/mixed_correction.hpp"
#include "support/random_step.hpp"

using namespace tektite;

namespace {

constexpr double spacing = 0.5, ratio = 1.3;
constexpr double support = 2.0 * ratio * spacing;

/// What a body fills of the lattice points: so many on either side of the origin, the farthest of them within a ball or
/// all in a box.
template <int D>
struct Shape {
  std::array<int, D> half;
  bool round;
};
template <int D>
Shape<D> ball() {
  Shape<D> shape{{}, true};
  shape.half.fill(D == 3 ? 4 : 9);
  return shape;
}

/// A body of lattice points, a few of them missing, and some that lie beside symmetry planes.
template <int D>
Particles body_of(const Shape<D>& shape) {
  constexpr Space space = D == 1 ? Space::line : D == 2 ? Space::plane_strain : Space::solid;
  std::vector<Vector<double, D>> places;
  int cells = 1;
  for (const int half : shape.half) cells *= 2 * half;
  for (int n = 0, rest; n < cells; ++n) {
    rest = n;
    Vector<double, D> x;
    for (int k = 0; k < D; ++k) {
      const int half = shape.half[static_cast<std::size_t>(k)];
      x[k] = spacing * (rest % (2 * half) - half + 0.5);
      rest /= 2 * half;
    }
    if ((!shape.round || norm(x) < shape.half[0] * spacing) && n % 17 != 3) places.push_back(x);
  }
  Particles particles(space, {{"body", "rubber", spacing, {0, places.size()}}});
  for (const auto field : {Field::id, Field::reference_position, Field::smoothing_length}) particles.allocate(field);
  for (std::size_t i = 0; i < places.size(); ++i) {
    particles.template vectors<D>(Field::reference_position)[i] = places[i];
    particles.scalars(Field::smoothing_length)[i] = ratio * spacing;
  }
  return particles;
}

template <int D>
struct Outcome {
  std::vector<StressRecord<D>> deformed;
  std::vector<Vector<double, D>> acceleration;
  std::vector<double> power, signal;

  explicit Outcome(std::size_t count) : deformed(count), acceleration(count), power(count), signal(count) {}

  std::vector<double> numbers(std::size_t i) const {
    std::vector<double> all{power[i], signal[i]};
    all.insert(all.end(), std::begin(deformed[i].cofactor.c), std::end(deformed[i].cofactor.c));
    all.insert(all.end(), std::begin(deformed[i].stress.c), std::end(deformed[i].stress.c));
    all.insert(all.end(), std::begin(acceleration[i].c), std::end(acceleration[i].c));
    return all;
  }
};

/// A random state of the body and what both ways make of it.
template <int D>
class State {
 public:
  State(const Shape<D>& shape, std::vector<SymmetryPlane> planes)
      : particles_(body_of(shape)), mirror_(std::move(planes)), mass_(particles_.count(), 1.0) {
    const auto count = particles_.count();
    const ReferencePlaces<D> places(particles_, mirror_, support);
    pairs_ = reference_pairs(places, count, support);
    const std::vector<std::uint8_t> owned(places.x.size(), 1);
    lattices_.find(particles_, places.x, places.body, owned, support);
    const std::size_t all = count + mirror_.images();
    reference_.resize(all);
    motion_.resize(all);
    stress_.resize(all);
    shift_.resize(all);
    corrections_.resize(count);
    test::Random random(D);
    for (std::size_t i = 0; i < count; ++i) {
      const auto& x = particles_.template vectors<D>(Field::reference_position)[i];
      reference_[i] = {i % 23 == 5 ? 0.0 : random.between(0.9, 1.1), x, ratio * spacing, 1.0};
      for (int k = 0; k < D; ++k) {
        motion_[i].x[k] = x[k] + random.between(-0.1, 0.1);
        motion_[i].v[k] = random.between(-1.0, 1.0);
      }
      auto& s = stress_[i];
      s = {random.between(0.9, 1.1), 1.0, random.between(0.5, 1.0), random.gradient<D>(1.0),
           random.gradient<D>(1.0),  1.0};
      for (int k = 0; k < D; ++k) {
        shift_[i].stress[k] = random.between(-0.1, 0.1);
        shift_[i].cofactor[k] = random.between(-0.1, 0.1);
      }
      corrections_[i] = {random.gradient<D>(1.0), motion_[i].v};
    }
    mirror_.fill(reference_, count);
    mirror_.fill(motion_, count);
    mirror_.fill(stress_, count);
    mirror_.fill(shift_, count);
  }

  bool on_lattice() const { return lattices_.any(); }
  std::size_t count() const { return particles_.count(); }

  template <bool corrected>
  Outcome<D> by_lists() const {
    Outcome<D> outcome(count());
    const auto records = this->records();
    for_each_pair(pairs_, deformation<corrected>(records, outcome));
    for_each_pair(pairs_, forces<corrected>(records, outcome));
    return outcome;
  }
  template <bool corrected>
  Outcome<D> by_lattice() const {
    Outcome<D> outcome(count());
    lattices_.for_each_pair(
        records(), [&](const auto& copies) { return deformation<corrected>(copies, outcome); }, count());
    lattices_.for_each_pair(
        records(), [&](const auto& copies) { return forces<corrected>(copies, outcome); }, count());
    return outcome;
  }

 private:
  ListedRecords<D> records() const { return {reference_.data(), motion_.data(), stress_.data(), shift_.data()}; }

  template <bool corrected, class Records>
  auto deformation(const Records& records, Outcome<D>& to) const {
    return DeformationSums<CubicSpline, D, corrected, Records>{{records, reference_.data(), corrections_.data()},
                                                               to.deformed.data()};
  }
  template <bool corrected, class Records>
  auto forces(const Records& records, Outcome<D>& to) const {
    return LagrangianForces<CubicSpline, MonaghanViscosity, D, corrected, Records>{{records, reference_.data()},
                                                                                   MonaghanViscosity{1.0, 2.0},
                                                                                   stress_.data(),
                                                                                   shift_.data(),
                                                                                   mass_.data(),
                                                                                   to.acceleration.data(),
                                                                                   to.power.data(),
                                                                                   to.signal.data()};
  }

  Particles particles_;
  Mirror<D> mirror_;
  std::vector<double> mass_;
  PairList pairs_;
  LatticeBodies<CubicSpline, D> lattices_;
  std::vector<ReferenceRecord<D>> reference_;
  std::vector<MotionRecord<D>> motion_;
  std::vector<StressRecord<D>> stress_;
  std::vector<ShiftRecord<D>> shift_;
  std::vector<Correction<double, D>> corrections_;
};

template <int D>
void check_same(const Outcome<D>& a, const Outcome<D>& b, std::size_t count) {
  double most = 0.0, largest = 0.0;
  for (std::size_t i = 0; i < count; ++i) {
    const auto ours = a.numbers(i), theirs = b.numbers(i);
    for (std::size_t k = 0; k < ours.size(); ++k) {
      most = std::max(most, std::abs(ours[k] - theirs[k]));
      largest = std::max(largest, std::abs(theirs[k]));
    }
  }
  CHECK(largest > 1.0);
  CHECK(most < 1e-12 * largest);  // sums of some ten to a hundred numbers in another order
}

template <int D>
void check(const Shape<D>& shape, std::vector<SymmetryPlane> planes = {}) {
  INFO(D << " dimensions, " << planes.size() << " symmetry planes, " << (shape.round ? "a ball" : "a box"));
  const State<D> state(shape, std::move(planes));
  REQUIRE(state.on_lattice());
  check_same(state.template by_lattice<false>(), state.template by_lists<false>(), state.count());
  check_same(state.template by_lattice<true>(), state.template by_lists<true>(), state.count());
}

using Places = std::vector<Vector<double, 2>>;

bool is_lattice(const Places& places) {
  std::vector<std::uint32_t> members(places.size());
  for (std::uint32_t i = 0; i < members.size(); ++i) members[i] = i;
  return Lattice<2>::find(places, members, 1.0, 2.8).has_value();
}

Places square(double turned) {
  Places places;
  for (int i = 0; i < 20; ++i)
    for (int j = 0; j < 20; ++j)
      places.push_back({i * std::cos(turned) - j * std::sin(turned), i * std::sin(turned) + j * std::cos(turned)});
  return places;
}

}  // namespace

TEST_CASE("Lattice: its sums are those over lists, with holes, failed neighbours and symmetry planes", "[lattice]") {
  check(ball<1>());
  check(ball<2>());
  check(ball<3>());
  check(ball<2>(), {{1, -4.5}});
  check(ball<3>(), {{0, -2.0}, {2, -2.0}});
}

TEST_CASE("Lattice: a body of several beams has the sums of lists, whichever axis is its longest", "[lattice]") {
  check(Shape<1>{{300}, false});
  check(Shape<2>{{270, 5}, false});
  check(Shape<2>{{5, 270}, false});
  check(Shape<3>{{70, 9, 10}, false});
  check(Shape<3>{{3, 10, 70}, false});
  check(Shape<3>{{9, 70, 2}, false}, {{0, -4.5}});
}

TEST_CASE("Lattice: what does not lie on one is not taken for one", "[lattice]") {
  CHECK(is_lattice(square(0.0)));
  CHECK_FALSE(is_lattice(square(0.3)));
  auto moved = square(0.0);
  moved[150][1] += 1e-3;
  CHECK_FALSE(is_lattice(moved));
  auto doubled = square(0.0);
  doubled.push_back(doubled[37]);
  CHECK_FALSE(is_lattice(doubled));
  auto scattered = square(0.0);
  scattered.push_back({1e6, 1e6});
  CHECK_FALSE(is_lattice(scattered));
  CHECK_FALSE(is_lattice({}));
}
