#include "advice/symmetry.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numbers>
#include <optional>

#include "neighbours/cell_grid.hpp"

namespace tektite {
namespace {

/// Of a spacing: an image this near a particle is that particle. Lattices and rings are exact to 1e-9.
constexpr double same_place = 1e-3;
/// Of a spacing: a middle this near zero is zero but for the rounding of the places.
constexpr double rounding = 1e-9;
/// Of the largest speed, and of other numbers of their own.
constexpr double same_number = 1e-6;
/// Of a spacing: a turned body on a lattice has a particle within half a cell's diagonal, 0.87, or a little further at
/// a round surface; a corner sticks out by more.
constexpr double covered = 1.25;

template <int D>
class Twins {
 public:
  explicit Twins(const Particles& particles)
      : particles_(particles),
        positions_(particles.vectors<D>(Field::position)),
        velocities_(particles.vectors<D>(Field::velocity)) {
    double widest = 0.0;
    for (const auto& body : particles.bodies()) widest = std::max(widest, body.spacing);
    grid_.build({positions_, particles.count()}, 2.0 * covered * widest);
    for (std::size_t i = 0; i < particles.count(); ++i) speed_ = std::max(speed_, norm(velocities_[i]));
    for (int k = 0; k < D; ++k) {
      double low = std::numeric_limits<double>::infinity(), high = -low;
      for (std::size_t i = 0; i < particles.count(); ++i) {
        low = std::min(low, positions_[i][k]);
        high = std::max(high, positions_[i][k]);
      }
      const double middle = 0.5 * (low + high);
      middle_[k] = std::abs(middle) < rounding * widest ? 0.0 : middle;
    }
  }

  double middle(int axis) const { return middle_[axis]; }

  bool mirrored(int axis) const {
    return everyone([&](std::size_t i, const Body& body) {
      auto x = positions_[i], v = velocities_[i];
      x[axis] = 2.0 * middle_[axis] - x[axis];
      v[axis] = -v[axis];
      const auto twin = nearest(x, body, same_place * body.spacing);
      return twin && norm(velocities_[*twin] - v) <= same_number * speed_ && alike(i, *twin);
    });
  }

  /// Turned in the plane of axes a and b by an angle.
  bool turned(int a, int b, double angle) const {
    const double c = std::cos(angle), s = std::sin(angle);
    return everyone([&](std::size_t i, const Body& body) {
      auto x = positions_[i], v = velocities_[i];
      const double xa = x[a] - middle_[a], xb = x[b] - middle_[b], radius = std::hypot(xa, xb);
      x[a] = middle_[a] + c * xa - s * xb;
      x[b] = middle_[b] + s * xa + c * xb;
      v[a] = c * velocities_[i][a] - s * velocities_[i][b];
      v[b] = s * velocities_[i][a] + c * velocities_[i][b];
      const auto twin = nearest(x, body, covered * body.spacing);
      if (!twin || !alike(i, *twin)) return false;
      // Beside the axis a field that turns with the body changes by its own size over a radius.
      const double apart = norm(positions_[*twin] - x) / std::max(radius, body.spacing);
      const double across = std::hypot(v[a], v[b]);
      return norm(velocities_[*twin] - v) <= same_number * speed_ + 2.0 * apart * across;
    });
  }

  /// Whether nothing turns about the axis: spaces about an axis know no such motion.
  bool without_spin(int a, int b) const {
    return everyone([&](std::size_t i, const Body&) {
      const double xa = positions_[i][a] - middle_[a], xb = positions_[i][b] - middle_[b];
      const auto& v = velocities_[i];
      return std::abs(xa * v[b] - xb * v[a]) <= same_number * speed_ * std::hypot(xa, xb);
    });
  }

  /// About how many particles the section has.
  double section(int a, int b) const {
    double sum = 0.0;
    for (const auto& body : particles_.bodies())
      for (std::size_t i = body.range.begin; i < body.range.end; ++i) {
        const double radius = std::hypot(positions_[i][a] - middle_[a], positions_[i][b] - middle_[b]);
        sum += body.spacing / (2.0 * std::numbers::pi * std::max(radius, 0.5 * body.spacing));
      }
    return sum;
  }

 private:
  template <class Test>
  bool everyone(const Test& test) const {
    for (const auto& body : particles_.bodies())
      for (std::size_t i = body.range.begin; i < body.range.end; ++i)
        if (!test(i, body)) return false;
    return true;
  }

  std::optional<std::size_t> nearest(const Vector<double, D>& x, const Body& body, double within) const {
    std::optional<std::size_t> found;
    for (const auto cell : grid_.around(grid_.cell_of(x)))
      for (const auto j : grid_.members(cell)) {
        const double distance = norm(positions_[j] - x);
        if (j < body.range.begin || j >= body.range.end || distance > within) continue;
        within = distance;
        found = j;
      }
    return found;
  }

  /// Whether two particles carry the same. Masses may differ where rings meet: density says what is there.
  bool alike(std::size_t i, std::size_t j) const {
    for (const auto field : {Field::density, Field::specific_internal_energy})
      if (particles_.has(field)) {
        const double a = particles_.reals(field)[i], b = particles_.reals(field)[j];
        if (std::abs(a - b) > same_number * std::max(std::abs(a), std::abs(b))) return false;
      }
    for (const auto field : {Field::kernel_type, Field::clamped})
      if (particles_.has(field) && particles_.integers(field)[i] != particles_.integers(field)[j]) return false;
    return true;
  }

  const Particles& particles_;
  const Vector<double, D>* positions_;
  const Vector<double, D>* velocities_;
  CellGrid<D> grid_;
  double speed_ = 0.0;
  std::array<double, D> middle_{};
};

bool is_taken(const std::vector<SymmetryPlane>& taken, int axis) {
  return std::ranges::find(taken, axis, &SymmetryPlane::axis) != taken.end();
}

template <int D>
std::vector<SymmetryPlane> mirrors_in(const Particles& particles, const std::vector<SymmetryPlane>& taken) {
  const Twins<D> twins(particles);
  std::vector<SymmetryPlane> planes;
  for (int axis = 0; axis < D; ++axis)
    if (!is_taken(taken, axis) && twins.mirrored(axis)) planes.push_back({axis, twins.middle(axis), 1.0});
  return planes;
}

template <int D>
std::vector<Revolution> revolutions_in(const Particles& particles, const std::vector<SymmetryPlane>& taken) {
  // No multiple of one is a part of a full turn, so a regular polygon does not pass for a circle.
  constexpr std::array angles{std::numbers::pi / 4.0, 1.0};
  const Twins<D> twins(particles);
  std::vector<Revolution> found;
  for (int axis = D == 2 ? 2 : 0; axis < 3; ++axis) {
    const int a = (axis + 1) % 3, b = (axis + 2) % 3;
    if (is_taken(taken, a) || is_taken(taken, b)) continue;
    if (twins.without_spin(a, b) &&
        std::ranges::all_of(angles, [&](double angle) { return twins.turned(a, b, angle); }))
      found.push_back({axis, twins.section(a, b)});
  }
  return found;
}

}  // namespace

std::vector<SymmetryPlane> unused_mirrors(const Particles& particles, const std::vector<SymmetryPlane>& taken) {
  switch (particles.dimensions()) {
    case 1:
      return mirrors_in<1>(particles, taken);
    case 2:
      return mirrors_in<2>(particles, taken);
    default:
      return mirrors_in<3>(particles, taken);
  }
}

std::vector<Revolution> unused_revolutions(const Particles& particles, const std::vector<SymmetryPlane>& taken) {
  if (particles.dimensions() == 1 || hoops_of(particles.space()) > 0) return {};
  return particles.dimensions() == 2 ? revolutions_in<2>(particles, taken) : revolutions_in<3>(particles, taken);
}

}  // namespace tektite
