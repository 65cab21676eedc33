#include "neighbours/lattice.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>
#include <utility>

namespace tektite {
namespace {

constexpr double off_lattice = 1e-6;   ///< of the spacing: who is farther from a lattice point is not on the lattice
constexpr double least_filling = 0.1;  ///< of the box; an emptier one costs more to keep than lists do

template <int D>
using Point = std::array<std::ptrdiff_t, D>;

/// The lattice points of the members, the first member's being zero; none where one is off the lattice.
template <int D>
std::optional<std::vector<Point<D>>> points_of(std::span<const Vector<double, D>> places,
                                               std::span<const std::uint32_t> members, double spacing) {
  std::vector<Point<D>> points;
  for (const auto i : members) {
    Point<D> point;
    for (int k = 0; k < D; ++k) {
      const double steps = (places[i][k] - places[members.front()][k]) / spacing;
      if (!(std::abs(steps - std::round(steps)) < off_lattice)) return std::nullopt;
      point[static_cast<std::size_t>(k)] = std::lround(steps);
    }
    points.push_back(point);
  }
  return points;
}

}  // namespace

template <int D>
std::optional<Lattice<D>> Lattice<D>::find(std::span<const Vector<double, D>> places,
                                           std::span<const std::uint32_t> members, double spacing, double support) {
  if (members.empty()) return std::nullopt;
  const auto points = points_of<D>(places, members, spacing);
  if (!points) return std::nullopt;

  Point<D> low = points->front(), high = low;
  for (const auto& point : *points)
    for (std::size_t k = 0; k < D; ++k) {
      low[k] = std::min(low[k], point[k]);
      high[k] = std::max(high[k], point[k]);
    }
  Point<D> extent;
  for (std::size_t k = 0; k < D; ++k) extent[k] = high[k] - low[k] + 1;

  // Rows run along the longest axis; the axis of the planes, whose margin is not shared, is the next longest.
  std::array<std::size_t, D> axes;
  std::iota(axes.begin(), axes.end(), std::size_t{0});
  std::ranges::stable_sort(axes, [&](auto a, auto b) { return extent[a] > extent[b]; });
  if constexpr (D == 3) std::swap(axes[1], axes[2]);

  const auto margin = static_cast<std::ptrdiff_t>(support / spacing);
  // A whole number of packs of records, which is how they are filled in.
  constexpr auto wide = static_cast<std::ptrdiff_t>(wide_pack_width), width = static_cast<std::ptrdiff_t>(pack_width);
  const auto pitch = (std::max(extent[axes[0]], wide) + 2 * margin + width - 1) / width * width;
  Point<D> stride{};  // in rows
  std::ptrdiff_t rows = 1, reach = 0;
  double cells = static_cast<double>(pitch);
  for (std::size_t k = 1; k < D; ++k) {
    const auto axis = axes[k];
    cells *= static_cast<double>(extent[axis] + margin);
    if (cells * least_filling > static_cast<double>(members.size()) + 1e3) return std::nullopt;
    stride[axis] = rows;
    reach += margin * rows;
    rows *= extent[axis] + margin;
  }

  Lattice lattice;
  lattice.pitch_ = static_cast<std::size_t>(pitch);
  lattice.margin_ = static_cast<std::size_t>(margin);
  lattice.plane_ = static_cast<std::size_t>(D == 3 ? stride[axes[D - 1]] : rows);
  lattice.records_.assign(static_cast<std::size_t>((rows + 2 * reach) * pitch), nobody);
  for (std::size_t n = 0; n < points->size(); ++n) {
    std::ptrdiff_t row = reach;
    for (std::size_t k = 0; k < D; ++k) row += ((*points)[n][k] - low[k]) * stride[k];
    const auto column = margin + (*points)[n][axes[0]] - low[axes[0]];
    auto& record = lattice.records_[static_cast<std::size_t>(row * pitch + column)];
    if (record != nobody) return std::nullopt;
    record = members[n];
  }

  Point<D> step;
  step.fill(-margin);
  for (;;) {
    Neighbour neighbour{0, step[axes[0]], Vector<double, D>::zero()};
    for (std::size_t k = 0; k < D; ++k) {
      neighbour.rows += step[k] * stride[k];
      neighbour.x[static_cast<int>(k)] = -spacing * static_cast<double>(step[k]);
    }
    const double away = norm(neighbour.x);
    if (away > 0.0 && away < support) lattice.neighbours_.push_back(neighbour);
    std::size_t k = 0;
    while (k < D && step[k] == margin) step[k++] = -margin;
    if (k == D) break;
    ++step[k];
  }
  std::ranges::sort(lattice.neighbours_, [](const Neighbour& a, const Neighbour& b) {
    return std::pair(a.rows, a.columns) < std::pair(b.rows, b.columns);
  });
  return lattice;
}

template class Lattice<1>;
template class Lattice<2>;
template class Lattice<3>;

}  // namespace tektite
