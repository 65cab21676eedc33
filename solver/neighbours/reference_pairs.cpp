#include "neighbours/reference_pairs.hpp"

#include <algorithm>

#include "core/kernel_type.hpp"

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
PairList reference_pairs(const Particles& particles, Mirror<D>& mirror, double support) {
  const auto* x = particles.vectors<D>(Field::reference_position);
  std::vector<Vector<double, D>> places(x, x + particles.count());
  mirror.find(places, support);
  auto body = body_of_each(particles);
  mirror.repeat(body);
  CellGrid<D> grid;
  grid.build(places, support);
  PairList pairs;
  pairs.build<D>(grid, places, particles.count(), support, Pairing::within_bodies, body);
  return pairs;
}

template PairList reference_pairs<1>(const Particles&, Mirror<1>&, double);
template PairList reference_pairs<2>(const Particles&, Mirror<2>&, double);
template PairList reference_pairs<3>(const Particles&, Mirror<3>&, double);

}  // namespace tektite
