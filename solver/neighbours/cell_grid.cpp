#include "neighbours/cell_grid.hpp"

#include <algorithm>
#include <bit>
#include <cmath>

#include "parallel/for_each.hpp"

namespace tektite {
namespace {

constexpr std::int64_t least_side = 4;
constexpr double farthest = 1e15;  // cells; beyond, coordinates are clamped rather than overflow

}  // namespace

template <int D>
std::array<std::int64_t, D> CellGrid<D>::coordinates(const Vector<double, D>& x) const {
  std::array<std::int64_t, D> c;
  for (int k = 0; k < D; ++k)
    c[k] = static_cast<std::int64_t>(std::clamp(std::floor((x[k] - origin_[k]) / side_), -farthest, farthest));
  return c;
}

template <int D>
std::size_t CellGrid<D>::index(const std::array<std::int64_t, D>& c) const {
  std::int64_t index = 0;
  for (int k = D - 1; k >= 0; --k) index = index * size_[k] + (c[k] & (size_[k] - 1));
  return static_cast<std::size_t>(index);
}

template <int D>
std::size_t CellGrid<D>::cell_of(const Vector<double, D>& x) const {
  return index(coordinates(x));
}

template <int D>
auto CellGrid<D>::around(std::size_t cell) const -> std::array<std::size_t, around_count> {
  std::array<std::int64_t, D> centre;
  auto rest_of_cell = static_cast<std::int64_t>(cell);
  for (int k = 0; k < D; ++k) {
    centre[k] = rest_of_cell % size_[k];
    rest_of_cell /= size_[k];
  }
  std::array<std::size_t, around_count> cells;
  for (std::size_t n = 0; n < cells.size(); ++n) {
    auto c = centre;
    for (std::size_t k = 0, rest = n; k < D; ++k, rest /= 3) c[k] += static_cast<std::int64_t>(rest % 3) - 1;
    cells[n] = index(c);
  }
  return cells;
}

template <int D>
void CellGrid<D>::build(std::span<const Vector<double, D>> positions, double side, const Extent<D>& extent) {
  side_ = side;
  origin_ = extent.box.lower;
  const auto& upper = extent.box.upper;
  const double most = 2.0 * static_cast<double>(extent.count) + 256.0;
  double total = 1.0;
  for (int k = 0; k < D; ++k) {
    const double wanted = std::min((upper[k] - origin_[k]) / side_ + 1.0, most);
    size_[k] = std::max<std::int64_t>(
        least_side, static_cast<std::int64_t>(std::bit_ceil(static_cast<std::uint64_t>(std::ceil(wanted)))));
    total *= static_cast<double>(size_[k]);
  }
  while (total > most) {
    auto& largest = *std::max_element(size_.begin(), size_.end());
    if (largest == least_side) break;
    largest /= 2;
    total /= 2.0;
  }

  std::vector<std::uint32_t> cell(positions.size());
  for_each(positions.size(), [&](std::size_t i) { cell[i] = static_cast<std::uint32_t>(cell_of(positions[i])); });
  first_.assign(static_cast<std::size_t>(total) + 1, 0);
  for (const auto c : cell) ++first_[c + 1];
  for (std::size_t c = 1; c < first_.size(); ++c) first_[c] += first_[c - 1];
  members_.resize(positions.size());
  auto next = first_;
  for (std::size_t i = 0; i < positions.size(); ++i) members_[next[cell[i]]++] = static_cast<std::uint32_t>(i);
}

template class CellGrid<1>;
template class CellGrid<2>;
template class CellGrid<3>;

}  // namespace tektite
