#include "neighbours/neighbourhood.hpp"

#include <algorithm>

#include "core/saved_number.hpp"
#include "neighbours/extent.hpp"
#include "neighbours/order.hpp"
#include "neighbours/reference_pairs.hpp"
#include "parallel/for_each.hpp"
#include "parallel/reduce.hpp"

namespace tektite {
namespace {

/// Skin as a part of the support: a thicker one makes lists live longer and hold more that is not near. 0.12 and 0.3
/// were no faster on the hvi_2d example, within the scatter; the answer does not depend on it beyond round-off.
constexpr double skin_fraction = 0.2;

/// Side of a region in supports: particles of regions that do not touch were at least this far apart.
constexpr double region_side = 4.0;

/// Neighbours part slowly: particles that were ordered a few searches ago are still read nearly in the order of memory.
constexpr int searches_per_order = 8;

/// The skin has to outlast at least this many half steps at the present speeds.
constexpr double least_half_steps = 4.0;

}  // namespace

template <int D>
Neighbourhood<D>::Neighbourhood(Particles& particles, double support, std::vector<SymmetryPlane> planes, Search search)
    : particles_(particles), support_(support), search_(std::move(search)), mirror_(std::move(planes)) {}

template <int D>
auto Neighbourhood<D>::approach(double dt) -> Approach {
  using Box = VectorBox<D>;
  const Particles& particles = particles_;
  const auto *x = particles.vectors<D>(Field::position), *v = particles.vectors<D>(Field::velocity),
             *a = particles.vectors<D>(Field::acceleration), *from = particles.vectors<D>(search_.positions);
  const double ahead = 0.5 * dt;
  boxes_.assign(regions_.cells(), Box{});
  for_each(occupied_.size(), [&](std::size_t n) {
    const auto region = occupied_[n];
    for (const auto i : regions_.members(region))
      boxes_[region].take(x[i] + ahead * (v[i] + (0.5 * ahead) * a[i]) - from[i]);
  });
  const auto widest = [&](double& near, std::size_t region) {
    if (boxes_[region].empty()) return;
    for (const auto other : regions_.around(region)) {
      Box both = boxes_[region];
      Box::join(both, boxes_[other]);
      near = std::max(near, both.diagonal(mirror_.planes()));
    }
  };
  each_over_ranks(particles, boxes_, Box::join);
  const double near =
      reduce(regions_.cells(), 0.0, widest, [](double& whole, double part) { whole = std::max(whole, part); });
  Box all{};
  for (const auto& box : boxes_) Box::join(all, box);
  return {near, all.diagonal(mirror_.planes())};
}

template <int D>
bool Neighbourhood<D>::due(double dt) {
  const auto nearer = approach(dt);
  return !(nearer.near <= reach_ - support_ && nearer.far <= (region_side - 1.0) * support_);
}

template <int D>
bool Neighbourhood<D>::prepare(double dt) {
  if (reach_ > 0.0 && (distributed(particles_) || !due(dt))) return false;
  return renew(dt);
}

template <int D>
bool Neighbourhood<D>::renew(double dt) {
  const bool ordered = begin(dt);
  list();
  return ordered;
}

template <int D>
bool Neighbourhood<D>::begin(double dt) {
  const bool orders = search_.orders && searches_since_order_ % searches_per_order == 0;
  if (orders) order_in_space<D>(particles_, support_);
  searches_since_order_ = orders ? 1 : searches_since_order_ + 1;
  const auto positions = particles_.reals(Field::position);
  std::copy(positions.begin(), positions.end(), particles_.reals(search_.positions).begin());
  find_regions();
  reach_ = support_ + std::max(skin_fraction * support_, least_half_steps * approach(dt).near);
  return orders;
}

template <int D>
Halo Neighbourhood<D>::halo(const std::map<std::string, double>& state, int sweeps) const {
  const auto reach = state.find(search_.name + "_reach");
  if (reach == state.end()) return {sweeps * (1.0 + skin_fraction) * support_, Field::position};
  return {sweeps * reach->second, search_.positions};
}

template <int D>
void Neighbourhood<D>::save(std::map<std::string, double>& state) const {
  state[search_.name + "_reach"] = reach_;
  if (search_.orders) state[search_.name + "es_since_order"] = searches_since_order_;
}

template <int D>
void Neighbourhood<D>::restore(const std::map<std::string, double>& state) {
  reach_ = saved_number(state, search_.name + "_reach");
  if (search_.orders) searches_since_order_ = static_cast<int>(saved_number(state, search_.name + "es_since_order"));
  if (!(reach_ > 0.0)) return;  // never made
  find_regions();
  list();
}

template <int D>
void Neighbourhood<D>::find_regions() {
  const Particles& particles = particles_;
  const auto* places = particles.vectors<D>(search_.positions);
  regions_.build({places, particles.count()}, region_side * support_,
                 extent_of_owned<D>(particles, {0, particles.count()}, places));
  occupied_.clear();
  for (std::uint32_t region = 0; region < regions_.cells(); ++region)
    if (!regions_.members(region).empty()) occupied_.push_back(region);
}

template <int D>
void Neighbourhood<D>::list() {
  ++lists_;
  const auto* x = particles_.vectors<D>(search_.positions);
  places_.assign(x, x + particles_.count());
  mirror_.find(places_, reach_);
  CellGrid<D> grid;
  grid.build(places_, reach_, extent_of_all<D>(particles_, places_));
  auto body = body_of_each(particles_);
  mirror_.repeat(body);
  const auto build = [&](const std::vector<std::uint8_t>& listed) {
    pairs_.build<D>(grid, places_, particles_.count(), {support_, reach_}, search_.pairing, body, listed);
  };
  if (search_.listed == Listed::all) {
    build({});
    if (search_.apart) keep_apart(body);
    if (search_.apart || search_.pairing == Pairing::across_bodies) find_members();
    return;
  }
  auto listed = eulerian_of_each(particles_);
  build(listed);
  if (search_.listed == Listed::eulerian_and_near) {
    for (const auto& block : pairs_.blocks())
      for (const auto j : block.neighbours) listed[mirror_.source_of(j, particles_.count())] = 1;
    build(listed);
  }
  find_members();
}

template <int D>
void Neighbourhood<D>::find_members() {
  const auto count = particles_.count();
  pairs_.drop_empty_runs();
  members_ = pairs_.members(count, [&](std::uint32_t j) { return mirror_.source_of(j, count); });
}

/// Drops the pairs of one body that a sum sees: of which one is Eulerian, and the neighbours of the reference
/// configuration.
template <int D>
void Neighbourhood<D>::keep_apart(const std::vector<std::uint32_t>& body) {
  struct Reference {
    Vector<double, D> x;
    void mirror(int axis, double at) { x[axis] = 2.0 * at - x[axis]; }
  };
  std::vector<Reference> reference(body.size());
  auto eulerian = eulerian_of_each(particles_);
  const auto* own = particles_.vectors<D>(Field::reference_position);
  for (std::size_t i = 0; i < particles_.count(); ++i) reference[i].x = own[i];
  mirror_.fill(reference, particles_.count());
  mirror_.repeat(eulerian);
  pairs_.keep_pairs([&](std::uint32_t i, std::uint32_t j) {
    if (body[i] != body[j]) return true;
    const auto distance = reference[i].x - reference[j].x;
    return eulerian[i] == 0 && eulerian[j] == 0 && dot(distance, distance) >= support_ * support_;
  });
}

template <int D>
std::size_t Neighbourhood<D>::memory() const {
  return pairs_.memory() + places_.size() * (sizeof(places_[0]) + 2 * sizeof(std::uint32_t)) +
         members_.capacity() * sizeof(members_[0]);
}

template class Neighbourhood<1>;
template class Neighbourhood<2>;
template class Neighbourhood<3>;

}  // namespace tektite
