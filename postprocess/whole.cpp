#include "postprocess/whole.hpp"

#include <fmt/format.h>

#include <unordered_map>

#include "core/error.hpp"
#include "core/kernel_type.hpp"

namespace tektite {
namespace {

std::vector<Point> points_of(const Particles& particles, Field field) {
  const auto width = static_cast<std::size_t>(particles.dimensions());
  const auto values = particles.reals(field);
  std::vector<Point> points(particles.count(), Point::zero());
  for (std::size_t i = 0; i < points.size(); ++i)
    for (std::size_t k = 0; k < width; ++k) points[i][static_cast<int>(k)] = values[i * width + k];
  return points;
}

template <class T>
void repeat(std::vector<T>& column) {
  const auto count = column.size();
  column.reserve(2 * count);
  for (std::size_t i = 0; i < count; ++i) column.push_back(column[i]);
}

void add_images(Whole& whole, const SymmetryPlane& plane, int bit) {
  const auto count = whole.count();
  repeat(whole.position);
  repeat(whole.velocity);
  repeat(whole.mass);
  repeat(whole.smoothing_length);
  repeat(whole.body);
  repeat(whole.id);
  repeat(whole.source);
  repeat(whole.image);
  repeat(whole.severed);
  for (std::size_t i = count; i < 2 * count; ++i) {
    whole.position[i][plane.axis] = 2.0 * plane.at - whole.position[i][plane.axis];
    whole.velocity[i][plane.axis] = -whole.velocity[i][plane.axis];
    whole.image[i] = static_cast<std::uint8_t>(whole.image[i] | 1u << bit);
  }
}

/// A total-Lagrangian particle whose damage has reached 1 is taken out of its neighbours' lists. An Eulerian one stays
/// in them, and so does one of a snapshot that does not tell kernel types.
std::vector<std::uint8_t> severed(const Particles& particles) {
  std::vector<std::uint8_t> chosen(particles.count(), 0);
  if (!particles.has(Field::damage) || !particles.has(Field::kernel_type)) return chosen;
  const auto damage = particles.reals(Field::damage);
  const auto type = particles.integers(Field::kernel_type);
  const auto total_lagrangian = static_cast<std::int64_t>(KernelType::total_lagrangian);
  for (std::size_t i = 0; i < chosen.size(); ++i) chosen[i] = damage[i] >= 1.0 && type[i] == total_lagrangian ? 1 : 0;
  return chosen;
}

std::uint64_t key_of(const Whole& whole, std::size_t i) {
  return static_cast<std::uint64_t>(whole.id[i]) << 3 | whole.image[i];
}

}  // namespace

std::int32_t Whole::body_named(const std::string& name) const {
  std::vector<std::string> known;
  for (std::size_t k = 0; k < bodies.size(); ++k) {
    if (bodies[k].name == name) return static_cast<std::int32_t>(k);
    known.push_back(bodies[k].name);
  }
  throw RunError(fmt::format("the particle files have no body {}; they have {}", name, join(known)));
}

Whole make_whole(const Snapshot& snapshot, const std::vector<SymmetryPlane>& planes) {
  const auto& particles = snapshot.particles;
  const auto count = particles.count();
  Whole whole;
  whole.dimensions = particles.dimensions();
  whole.time = snapshot.time();
  whole.bodies = particles.bodies();
  whole.position = points_of(particles, Field::position);
  whole.velocity = points_of(particles, Field::velocity);
  const auto mass = particles.reals(Field::mass).first(count);
  const auto smoothing_length = particles.reals(Field::smoothing_length).first(count);
  const auto id = particles.integers(Field::id).first(count);
  whole.mass.assign(mass.begin(), mass.end());
  whole.smoothing_length.assign(smoothing_length.begin(), smoothing_length.end());
  whole.id.assign(id.begin(), id.end());
  whole.body.resize(count);
  for (std::size_t k = 0; k < whole.bodies.size(); ++k)
    for (auto i = whole.bodies[k].range.begin; i < whole.bodies[k].range.end; ++i)
      whole.body[i] = static_cast<std::int32_t>(k);
  whole.source.resize(count);
  for (std::size_t i = 0; i < count; ++i) whole.source[i] = static_cast<std::uint32_t>(i);
  whole.image.assign(count, 0);
  whole.severed = severed(particles);
  for (std::size_t k = 0; k < planes.size(); ++k) {
    add_images(whole, planes[k], static_cast<int>(k));
    if (hoops_of(particles.space()) > 0 && planes[k].axis == 0) whole.axis_image = static_cast<std::uint8_t>(1u << k);
  }
  return whole;
}

std::vector<std::uint32_t> places_in(const Whole& initial, const Whole& now) {
  std::unordered_map<std::uint64_t, std::uint32_t> place_of;
  place_of.reserve(initial.count());
  for (std::size_t i = 0; i < initial.count(); ++i) place_of[key_of(initial, i)] = static_cast<std::uint32_t>(i);
  std::vector<std::uint32_t> places(now.count());
  for (std::size_t i = 0; i < now.count(); ++i) {
    const auto found = place_of.find(key_of(now, i));
    if (found == place_of.end())
      throw RunError(fmt::format("particle {} of the last snapshot is not in the first one", now.id[i]));
    places[i] = found->second;
  }
  return places;
}

}  // namespace tektite
