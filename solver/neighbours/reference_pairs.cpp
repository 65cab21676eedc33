#include "neighbours/reference_pairs.hpp"

#include <algorithm>

#include "core/kernel_type.hpp"
#include "neighbours/extent.hpp"

namespace tektite {

std::vector<std::uint32_t> body_of_each(const Particles& particles) {
  std::vector<std::uint32_t> body;
  for (std::uint32_t k = 0; k < particles.bodies().size(); ++k)
    body.insert(body.end(), particles.bodies()[k].range.size(), k);
  return body;
}

std::vector<std::uint8_t> eulerian_of_each(const Particles& particles) {
  const auto types = particles.integers(Field::kernel_type);
  std::vector<std::uint8_t> eulerian(types.size());
  std::ranges::transform(types, eulerian.begin(),
                         [](auto type) { return type == static_cast<std::int64_t>(KernelType::eulerian) ? 1 : 0; });
  return eulerian;
}

template <int D>
ReferencePlaces<D>::ReferencePlaces(const Particles& particles, Mirror<D>& mirror, double support)
    : body(body_of_each(particles)) {
  const auto* own = particles.vectors<D>(Field::reference_position);
  x.assign(own, own + particles.count());
  mirror.find(x, support);
  mirror.repeat(body);
  extent = extent_of_all<D>(particles, x);
}

template <int D>
PairList reference_pairs(const ReferencePlaces<D>& places, std::size_t count, double support,
                         std::span<const std::uint8_t> listed) {
  CellGrid<D> grid;
  grid.build(places.x, support, places.extent);
  PairList pairs;
  pairs.build<D>(grid, places.x, count, support, Pairing::within_bodies, places.body, listed);
  return pairs;
}

template struct ReferencePlaces<1>;
template struct ReferencePlaces<2>;
template struct ReferencePlaces<3>;
template PairList reference_pairs<1>(const ReferencePlaces<1>&, std::size_t, double, std::span<const std::uint8_t>);
template PairList reference_pairs<2>(const ReferencePlaces<2>&, std::size_t, double, std::span<const std::uint8_t>);
template PairList reference_pairs<3>(const ReferencePlaces<3>&, std::size_t, double, std::span<const std::uint8_t>);

}  // namespace tektite
