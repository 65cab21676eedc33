#include "preprocess/overlap.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include "parallel/agreed.hpp"
#include "preprocess/dealing.hpp"

namespace tektite::preprocess {
namespace {

// Bodies that touch have particles exactly on the common edge, or exactly half a spacing apart; their coordinates are
// sums of several rounded numbers, so a millionth of a spacing is allowed here.
constexpr double touch_tolerance = 1e-6;

// Of the smaller spacing. Shapes of rounded numbers and of facets may reach into each other by as much; what does by
// more has so much of its mass twice.
constexpr double overlap_tolerance = 0.1;

using Cell = std::array<long long, 3>;  ///< z, y, x, so that sorted cells follow each other along x

bool within(const Point& p, const Box& box, double margin, int dimensions) {
  for (int k = 0; k < dimensions; ++k)
    if (p[k] < box.lower[k] - margin || p[k] > box.upper[k] + margin) return false;
  return true;
}

std::vector<Point> near_box(const FilledBody& body, const Box& box, double margin) {
  std::vector<Point> near;
  for (const auto& p : body.positions)
    if (within(p, box, margin, body.plan.shape->dimensions())) near.push_back(p);
  return near;
}

InputError fault(const FilledBody& a, const FilledBody& b, const Point& p, const std::string& how) {
  return a.plan.section.fault("shape", fmt::format("body {} overlaps body {}: at ({:g}, {:g}, {:g}) m {}", a.plan.name,
                                                   b.plan.name, p[0], p[1], p[2], how));
}

void check_inside(const FilledBody& a, const FilledBody& b, const std::vector<Point>& particles_of_a) {
  auto first = particles_of_a.size();
#pragma omp parallel for schedule(dynamic, 1024) reduction(min : first)
  for (std::size_t k = 0; k < particles_of_a.size(); ++k)
    if (b.plan.shape->inside(particles_of_a[k], -touch_tolerance * b.spacing)) first = std::min(first, k);
  if (first < particles_of_a.size())
    throw fault(a, b, particles_of_a[first], fmt::format("a particle of {} lies inside {}", a.plan.name, b.plan.name));
}

/// Points sorted into cells as large as the distance that is looked for, so that only neighbouring cells matter.
class Grid {
 public:
  Grid(const std::vector<Point>& points, double size) : size_(size) {
    for (const auto& p : points) sorted_.emplace_back(cell_of(p), p);
    const auto key = [](const auto& entry) { return std::pair(entry.first, as_cell_order(entry.second)); };
    std::sort(sorted_.begin(), sorted_.end(), [&](const auto& a, const auto& b) { return key(a) < key(b); });
  }

  /// The nearest point that is nearer than the size; null where there is none. Of several as near the same one,
  /// whatever other points there are.
  const Point* nearest(const Point& p) const {
    const auto centre = cell_of(p);
    const Point* found = nullptr;
    double least = size_;
    for (long long z = -1; z <= 1; ++z)
      for (long long y = -1; y <= 1; ++y) {
        const Cell from{centre[0] + z, centre[1] + y, centre[2] - 1};
        const Cell to{centre[0] + z, centre[1] + y, centre[2] + 1};
        auto at = std::lower_bound(sorted_.begin(), sorted_.end(), from,
                                   [](const auto& entry, const Cell& cell) { return entry.first < cell; });
        for (; at != sorted_.end() && at->first <= to; ++at)
          if (const double distance = norm(at->second - p); distance < least) {
            least = distance;
            found = &at->second;
          }
      }
    return found;
  }

 private:
  static std::array<double, 3> as_cell_order(const Point& p) { return {p[2], p[1], p[0]}; }
  Cell cell_of(const Point& p) const {
    return {std::llround(std::floor(p[2] / size_)), std::llround(std::floor(p[1] / size_)),
            std::llround(std::floor(p[0] / size_))};
  }

  double size_;
  std::vector<std::pair<Cell, Point>> sorted_;
};

/// A particle of one body and the nearest of another one.
struct Neighbours {
  Point p, q;
};

std::vector<Neighbours> neighbours(const std::vector<Point>& particles_of_a, const std::vector<Point>& particles_of_b,
                                   double reach) {
  const Grid grid(particles_of_b, reach);
  std::vector<const Point*> nearest(particles_of_a.size());
#pragma omp parallel for schedule(dynamic, 1024)
  for (std::size_t k = 0; k < nearest.size(); ++k) nearest[k] = grid.nearest(particles_of_a[k]);
  std::vector<Neighbours> found;
  for (std::size_t k = 0; k < nearest.size(); ++k)
    if (nearest[k]) found.push_back({particles_of_a[k], *nearest[k]});
  return found;
}

void check_distance(const FilledBody& a, const FilledBody& b, const std::vector<Neighbours>& pairs) {
  const double half = 0.5 * std::min(a.spacing, b.spacing);
  for (const auto& [p, q] : pairs)
    if (norm(q - p) < half * (1.0 - touch_tolerance))
      throw fault(a, b, p, fmt::format("their particles are nearer than half a spacing, {:g} m", half));
}

/// Where the way from p, in a shape, to q leaves it.
Point end_of(const Shape& shape, const Neighbours& way) {
  double in = 0.0, out = 1.0;
  while (out - in > touch_tolerance) {
    const double middle = 0.5 * (in + out);
    (shape.inside(way.p + middle * (way.q - way.p), 0.0) ? in : out) = middle;
  }
  return way.p + in * (way.q - way.p);
}

/// On the way from a particle of a to one of b a ends before b begins. Where it ends within b the shapes overlap, which
/// the particles of lattices that stay half a spacing off the faces do only from half a spacing on.
void check_between(const FilledBody& a, const FilledBody& b, const std::vector<Neighbours>& pairs) {
  const double deep = overlap_tolerance * std::min(a.spacing, b.spacing);
  auto first = pairs.size();
#pragma omp parallel for schedule(dynamic, 1024) reduction(min : first)
  for (std::size_t k = 0; k < pairs.size(); ++k)
    if (b.plan.shape->inside(end_of(*a.plan.shape, pairs[k]), -deep)) first = std::min(first, k);
  if (first < pairs.size())
    throw fault(a, b, end_of(*a.plan.shape, pairs[first]),
                fmt::format("{} reaches into {} by more than {:g} spacings, {:g} m; bodies may touch", a.plan.name,
                            b.plan.name, overlap_tolerance, deep));
}

}  // namespace

void check_overlaps(std::span<const FilledBody> bodies) {
  for (std::size_t i = 0; i < bodies.size(); ++i)
    for (std::size_t j = i + 1; j < bodies.size(); ++j) {
      const auto &a = bodies[i], &b = bodies[j];
      const double margin = a.spacing + b.spacing;  // twice as far as cells in touch have their middles
      const auto near_b = near_box(a, b.plan.shape->bounds(), margin);
      const auto near_a = near_box(b, a.plan.shape->bounds(), margin);
      agreed([&] {
        check_inside(a, b, near_b);
        return true;
      });
      agreed([&] {
        check_inside(b, a, near_a);
        return true;
      });
      const auto near_own_b = points_about(near_b, margin, near_a);
      agreed([&] {
        const auto pairs = neighbours(near_b, near_own_b, margin);
        check_distance(a, b, pairs);
        check_between(a, b, pairs);
        return true;
      });
    }
}

}  // namespace tektite::preprocess
