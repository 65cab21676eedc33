#include "neighbours/order.hpp"

#include <algorithm>

#include "neighbours/extent.hpp"

namespace tektite {

template <int D>
void order_in_space(Particles& particles, double side) {
  const auto* x = particles.vectors<D>(Field::position);
  const auto* id = particles.integers(Field::id).data();
  auto* const sequence = distributed(particles) ? particles.integers(Field::sequence).data() : nullptr;
  std::vector<std::uint32_t> order(particles.count()), members;
  CellGrid<D> grid;
  for (const auto& body : particles.bodies()) {
    const std::span places(x + body.range.begin, body.range.size());
    grid.build(places, side, extent_of_owned<D>(particles, body.range, x));
    std::size_t next = body.range.begin;
    for (std::size_t cell = 0; cell < grid.cells(); ++cell) {
      const auto in_cell = grid.members(cell);
      members.assign(in_cell.begin(), in_cell.end());
      for (auto& i : members) i += static_cast<std::uint32_t>(body.range.begin);
      std::ranges::sort(members, {}, [id](std::uint32_t i) { return id[i]; });
      for (const auto i : members) {
        order[next++] = i;
        if (sequence) sequence[i] = static_cast<std::int64_t>(cell);
      }
    }
  }
  if (!std::is_sorted(order.begin(), order.end())) particles.permute(order);
}

template void order_in_space<1>(Particles&, double);
template void order_in_space<2>(Particles&, double);
template void order_in_space<3>(Particles&, double);

}  // namespace tektite
