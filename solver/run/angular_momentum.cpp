#include "run/angular_momentum.hpp"

#include <algorithm>

#include "core/tensor.hpp"
#include "parallel/reduce.hpp"

namespace tektite {
namespace {

/// What is slower than this part of its own speed, as seen by who flies along with the centre of mass, does not turn:
/// it is what round-off, 1e-16 of the speed a step, has left after any number of steps.
constexpr double next_to_rest = 1e-9;

/// Places are taken from the first particle, so that far from the origin nothing is lost to round-off.
template <int D>
struct Moments {
  double mass = 0.0;
  Vector<double, D> position = Vector<double, D>::zero(), velocity = Vector<double, D>::zero();  ///< times the mass
  Vector<double, 3> turning = Vector<double, 3>::zero();                                         ///< m x × v

  Moments& operator+=(const Moments& part) {
    mass += part.mass;
    position += part.position;
    velocity += part.velocity;
    turning += part.turning;
    return *this;
  }
};

template <int D>
Vector<double, 3> cross(const Vector<double, D>& a, const Vector<double, D>& b) {
  auto product = Vector<double, 3>::zero();
  if constexpr (D == 3) {
    product[0] = a[1] * b[2] - a[2] * b[1];
    product[1] = a[2] * b[0] - a[0] * b[2];
  }
  product[2] = a[0] * b[1] - a[1] * b[0];
  return product;
}

template <int D>
Moments<D> moments_of(const Particles& p) {
  const double* mass = p.scalars(Field::mass);
  const auto *x = p.vectors<D>(Field::position), *v = p.vectors<D>(Field::velocity);
  return reduce(
      p.count(), Moments<D>{},
      [=](Moments<D>& sums, std::size_t i) {
        const auto arm = x[i] - x[0];
        sums += {mass[i], mass[i] * arm, mass[i] * v[i], mass[i] * cross(arm, v[i])};
      },
      [](Moments<D>& whole, const Moments<D>& part) { whole += part; });
}

template <int D>
std::vector<double> about_centre(const Particles& p) {
  const auto moments = moments_of<D>(p);
  const auto of_centre = (1.0 / moments.mass) * cross(moments.position, moments.velocity);
  std::vector<double> components;
  for (const int axis : axes_of_turning(p.space())) components.push_back(moments.turning[axis] - of_centre[axis]);
  return components;
}

template <int D>
double largest(const Particles& p) {
  const auto moments = moments_of<D>(p);
  const double* mass = p.scalars(Field::mass);
  const auto *x = p.vectors<D>(Field::position), *v = p.vectors<D>(Field::velocity);
  const auto centre = x[0] + (1.0 / moments.mass) * moments.position, mean = (1.0 / moments.mass) * moments.velocity;
  return reduce(
      p.count(), 0.0,
      [&](double& sum, std::size_t i) {
        sum += mass[i] * norm(x[i] - centre) * std::max(norm(v[i] - mean), next_to_rest * norm(v[i]));
      },
      [](double& whole, double part) { whole += part; });
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

std::vector<double> angular_momentum_of(const Particles& p) {
  if (axes_of_turning(p.space()).empty()) return {};
  return p.dimensions() == 3 ? about_centre<3>(p) : about_centre<2>(p);
}

double largest_angular_momentum_of(const Particles& p) {
  if (axes_of_turning(p.space()).empty()) return 0.0;
  return p.dimensions() == 3 ? largest<3>(p) : largest<2>(p);
}

}  // namespace tektite
