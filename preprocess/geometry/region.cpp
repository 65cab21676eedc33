#include "preprocess/geometry/region.hpp"

#include <CGAL/Boolean_set_operations_2.h>
#include <CGAL/Exact_predicates_exact_constructions_kernel.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Gps_circle_segment_traits_2.h>
#include <CGAL/Polygon_2.h>

#include <boost/variant/get.hpp>

#include <cmath>
#include <iterator>
#include <list>

namespace tektite::preprocess {
namespace {

using Kernel = CGAL::Exact_predicates_exact_constructions_kernel;
using Traits = CGAL::Gps_circle_segment_traits_2<Kernel>;
using Polygon = Traits::Polygon_2;
using Arc = Traits::X_monotone_curve_2;

struct PlaneVector {
  double x = 0.0, y = 0.0;
};

template <class ArcEnd>
PlaneVector rounded(const ArcEnd& end) {
  return {CGAL::to_double(end.x()), CGAL::to_double(end.y())};
}

double cross(const PlaneVector& a, const PlaneVector& b) { return a.x * b.y - a.y * b.x; }

/// The part of Green's integral ½ ∮ (x dy − y dx) along one curve: its chord, and the circular segment above that.
double swept_area(const Arc& arc) {
  const auto s = rounded(arc.source()), t = rounded(arc.target());
  const double chord = 0.5 * cross(s, t);
  if (arc.is_linear()) return chord;
  const auto c = rounded(arc.supporting_circle().center());
  const double radius_squared = CGAL::to_double(arc.supporting_circle().squared_radius());
  const PlaneVector a{s.x - c.x, s.y - c.y}, b{t.x - c.x, t.y - c.y};
  const double angle = std::atan2(std::abs(cross(a, b)), a.x * b.x + a.y * b.y);  // x-monotone: at most a half circle
  const double segment = 0.5 * radius_squared * (angle - std::sin(angle));
  return arc.orientation() == CGAL::COUNTERCLOCKWISE ? chord + segment : chord - segment;
}

/// The part of Green's integral ½ ∮ x² dy along one curve.
double swept_moment(const Arc& arc) {
  const auto s = rounded(arc.source()), t = rounded(arc.target());
  if (arc.is_linear()) return (t.y - s.y) * (s.x * s.x + s.x * t.x + t.x * t.x) / 6.0;
  const auto c = rounded(arc.supporting_circle().center());
  const double radius = std::sqrt(CGAL::to_double(arc.supporting_circle().squared_radius()));
  const PlaneVector a{s.x - c.x, s.y - c.y}, b{t.x - c.x, t.y - c.y};
  const double size = std::atan2(std::abs(cross(a, b)), a.x * b.x + a.y * b.y);
  const double turn = arc.orientation() == CGAL::COUNTERCLOCKWISE ? size : -size;
  // of x = c.x + radius cos θ and dy = radius cos θ dθ
  const auto up_to = [&](const PlaneVector& end) {
    const double cosine = end.x / radius, sine = end.y / radius;
    return c.x * c.x * sine + c.x * radius * sine * cosine + radius * radius * (sine - sine * sine * sine / 3.0);
  };
  return 0.5 * radius * (up_to(b) - up_to(a) + c.x * radius * turn);
}

double sum_over(const Polygon& polygon, double (*of_arc)(const Arc&)) {
  double sum = 0.0;
  for (auto arc = polygon.curves_begin(); arc != polygon.curves_end(); ++arc) sum += of_arc(*arc);
  return sum;
}

/// Outer boundaries run counter-clockwise, those of holes clockwise.
double sum_over(const CGAL::General_polygon_set_2<Traits>& polygons, double (*of_arc)(const Arc&)) {
  std::list<Traits::Polygon_with_holes_2> parts;
  polygons.polygons_with_holes(std::back_inserter(parts));
  double sum = 0.0;
  for (const auto& part : parts) {
    sum += sum_over(part.outer_boundary(), of_arc);
    for (auto hole = part.holes_begin(); hole != part.holes_end(); ++hole) sum += sum_over(*hole, of_arc);
  }
  return sum;
}

}  // namespace

struct Region::Set {
  CGAL::General_polygon_set_2<Traits> polygons;
};

Region Region::polygon(const std::vector<PlanePoint>& corners) {
  Polygon polygon;
  for (std::size_t k = 0; k < corners.size(); ++k) {
    const auto& a = corners[k];
    const auto& b = corners[(k + 1) % corners.size()];
    if (a != b) polygon.push_back(Arc(Kernel::Point_2(a[0], a[1]), Kernel::Point_2(b[0], b[1])));
  }
  if (polygon.orientation() == CGAL::CLOCKWISE) polygon.reverse_orientation();
  auto set = std::make_shared<Set>();
  set->polygons.insert(polygon);
  return Region(set);
}

Region Region::disc(const PlanePoint& centre, double radius) {
  const Kernel::FT exact_radius(radius);
  const Kernel::Circle_2 circle(Kernel::Point_2(centre[0], centre[1]), exact_radius * exact_radius,
                                CGAL::COUNTERCLOCKWISE);
  std::list<boost::variant<Traits::Point_2, Arc>> pieces;
  Traits().make_x_monotone_2_object()(Traits::Curve_2(circle), std::back_inserter(pieces));
  Polygon polygon;
  for (const auto& piece : pieces) polygon.push_back(boost::get<Arc>(piece));
  auto set = std::make_shared<Set>();
  set->polygons.insert(polygon);
  return Region(set);
}

Region Region::joined(const Region& other) const {
  auto result = std::make_shared<Set>(*set_);
  result->polygons.join(other.set_->polygons);
  return Region(result);
}

Region Region::without(const Region& other) const {
  auto result = std::make_shared<Set>(*set_);
  result->polygons.difference(other.set_->polygons);
  return Region(result);
}

Region Region::common(const Region& other) const {
  auto result = std::make_shared<Set>(*set_);
  result->polygons.intersection(other.set_->polygons);
  return Region(result);
}

double Region::area() const { return sum_over(set_->polygons, swept_area); }

double Region::first_moment() const { return sum_over(set_->polygons, swept_moment); }

bool is_simple(const std::vector<PlanePoint>& corners) {
  using Corner = CGAL::Exact_predicates_inexact_constructions_kernel;
  CGAL::Polygon_2<Corner> polygon;
  for (const auto& corner : corners) polygon.push_back(Corner::Point_2(corner[0], corner[1]));
  return polygon.is_simple();
}

}  // namespace tektite::preprocess
