#include "neighbours/order.hpp"

#include <algorithm>

#include "neighbours/cell_grid.hpp"

namespace tektite {

template <int D>
void order_in_space(Particles& particles, double side) {
  const auto* x = particles.vectors<D>(Field::position);
  std::vector<std::uint32_t> order(particles.count());
  CellGrid<D> grid;
  for (const auto& body : particles.bodies()) {
    grid.build({x + body.range.begin, body.range.size()}, side);
    std::size_t next = body.range.begin;
    for (std::size_t cell = 0; cell < grid.cells(); ++cell)
      for (const auto i : grid.members(cell)) order[next++] = static_cast<std::uint32_t>(body.range.begin + i);
  }
  if (!std::is_sorted(order.begin(), order.end())) particles.permute(order);
}

template void order_in_space<1>(Particles&, double);
template void order_in_space<2>(Particles&, double);
template void order_in_space<3>(Particles&, double);

}  // namespace tektite
