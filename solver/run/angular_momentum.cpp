#include "run/angular_momentum.hpp"

#include <algorithm>
#include <limits>

#include "core/tensor.hpp"
#include "parallel/reduce.hpp"
#include "parallel/sums.hpp"

namespace tektite {
namespace {

/// What is slower than this part of its own speed, as seen by who flies along with the centre of mass, does not turn:
/// it is what round-off, 1e-16 of the speed a step, has left after any number of steps.
constexpr double next_to_rest = 1e-9;

/// How many axes something can turn about.
template <int D>
constexpr int turns = D == 3 ? 3 : 1;

/// a × b; in the plane its only component, along z.
template <int D>
Vector<double, turns<D>> cross(const Vector<double, D>& a, const Vector<double, D>& b) {
  Vector<double, turns<D>> product;
  if constexpr (D == 3) {
    product[0] = a[1] * b[2] - a[2] * b[1];
    product[1] = a[2] * b[0] - a[0] * b[2];
  }
  product[turns<D> - 1] = a[0] * b[1] - a[1] * b[0];
  return product;
}

/// Mass, position and velocity times mass, and m x × v.
template <int D>
struct Moments {
  double mass;
  Vector<double, D> position, velocity;
  Vector<double, turns<D>> turning;
};

/// Where the particle of the least id is: from there places are taken, so that far from the origin nothing is lost to
/// round-off.
template <int D>
Vector<double, D> first_place(const Particles& p) {
  struct First {
    std::int64_t id = std::numeric_limits<std::int64_t>::max();
    Vector<double, D> x = Vector<double, D>::zero();
  };
  const auto join = [](First& whole, const First& part) {
    if (part.id < whole.id) whole = part;
  };
  return reduce(
             p, First{},
             [=, id = p.integers(Field::id).data(), x = p.vectors<D>(Field::position)](First& first, std::size_t i) {
               if (id[i] < first.id) first = {id[i], x[i]};
             },
             join)
      .x;
}

template <int D>
using MomentSum = RepeatedSum<count_of_moments(D)>;

template <int D>
Moments<D> moments_of(const Particles& p, const Vector<double, D>& origin, MomentSum<D>& sum) {
  const double* mass = p.scalars(Field::mass);
  const auto *x = p.vectors<D>(Field::position), *v = p.vectors<D>(Field::velocity);
  const auto sums = sum(p, [=](std::size_t i) {
    const auto arm = mass[i] * (x[i] - origin);
    const auto turning = cross(arm, v[i]);
    std::array<double, count_of_moments(D)> terms{mass[i]};
    std::size_t n = 1;
    for (int k = 0; k < D; ++k) terms[n++] = arm[k];
    for (int k = 0; k < D; ++k) terms[n++] = mass[i] * v[i][k];
    for (int k = 0; k < turns<D>; ++k) terms[n++] = turning[k];
    return terms;
  });
  Moments<D> moments{sums[0], {}, {}, {}};
  std::size_t n = 1;
  for (int k = 0; k < D; ++k) moments.position[k] = sums[n++];
  for (int k = 0; k < D; ++k) moments.velocity[k] = sums[n++];
  for (int k = 0; k < turns<D>; ++k) moments.turning[k] = sums[n++];
  return moments;
}

template <int D>
std::vector<double> about_centre(const Particles& p, MomentSum<D>& sum) {
  const auto moments = moments_of<D>(p, first_place<D>(p), sum);
  const auto of_centre = (1.0 / moments.mass) * cross(moments.position, moments.velocity);
  std::vector<double> components;
  for (int k = 0; k < turns<D>; ++k) components.push_back(moments.turning[k] - of_centre[k]);
  return components;
}

template <int D>
double largest(const Particles& p) {
  const auto origin = first_place<D>(p);
  MomentSum<D> sum;
  const auto moments = moments_of<D>(p, origin, sum);
  const double* mass = p.scalars(Field::mass);
  const auto *x = p.vectors<D>(Field::position), *v = p.vectors<D>(Field::velocity);
  const auto centre = origin + (1.0 / moments.mass) * moments.position, mean = (1.0 / moments.mass) * moments.velocity;
  return sum_over<1>(p, [&](std::size_t i) {
    return std::array{mass[i] * norm(x[i] - centre) * std::max(norm(v[i] - mean), next_to_rest * norm(v[i]))};
  })[0];
}

}  // namespace

std::vector<int> axes_of_turning(Space space) {
  switch (space) {
    case Space::solid:
      return {0, 1, 2};
    case Space::plane_strain:
    case Space::plane_stress:
      return {2};
    default:
      return {};
  }
}

std::vector<double> AngularMomentum::operator()(const Particles& p) {
  if (axes_of_turning(p.space()).empty()) return {};
  return p.dimensions() == 3 ? about_centre<3>(p, in_space_) : about_centre<2>(p, in_plane_);
}

double largest_angular_momentum_of(const Particles& p) {
  if (axes_of_turning(p.space()).empty()) return 0.0;
  return p.dimensions() == 3 ? largest<3>(p) : largest<2>(p);
}

}  // namespace tektite
