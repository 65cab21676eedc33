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
using Point = typename Lattice<D>::Point;

/// The lattice point of a place; none where it is off the lattice.
template <int D>
std::optional<Point<D>> point_of(const Vector<double, D>& place, const Vector<double, D>& anchor, double spacing) {
  Point<D> point;
  for (int k = 0; k < D; ++k) {
    const double steps = (place[k] - anchor[k]) / spacing;
    if (!(std::abs(steps - std::round(steps)) < off_lattice)) return std::nullopt;
    point[static_cast<std::size_t>(k)] = std::lround(steps);
  }
  return point;
}

}  // namespace

template <int D>
auto Lattice<D>::frame_of(std::span<const Vector<double, D>> places, std::span<const std::uint32_t> members,
                          const Vector<double, D>& anchor, double spacing) -> Frame {
  Frame frame{anchor, spacing};
  for (const auto i : members) {
    const auto point = point_of<D>(places[i], anchor, spacing);
    if (!point) {
      frame.sound = false;
      return frame;
    }
    for (std::size_t k = 0; k < D; ++k) {
      frame.low[k] = std::min(frame.low[k], (*point)[k]);
      frame.high[k] = std::max(frame.high[k], (*point)[k]);
    }
  }
  frame.count = members.size();
  return frame;
}

template <int D>
void Lattice<D>::Frame::join(Frame& whole, const Frame& part) {
  for (std::size_t k = 0; k < D; ++k) {
    whole.low[k] = std::min(whole.low[k], part.low[k]);
    whole.high[k] = std::max(whole.high[k], part.high[k]);
  }
  whole.count += part.count;
  whole.sound = whole.sound && part.sound;
}

template <int D>
std::optional<Lattice<D>> Lattice<D>::find(std::span<const Vector<double, D>> places,
                                           std::span<const std::uint32_t> members, double spacing, double support) {
  if (members.empty()) return std::nullopt;
  return find(places, members, support, frame_of(places, members, places[members.front()], spacing));
}

template <int D>
std::optional<Lattice<D>> Lattice<D>::find(std::span<const Vector<double, D>> places,
                                           std::span<const std::uint32_t> members, double support, const Frame& whole) {
  if (!whole.sound) return std::nullopt;
  const double spacing = whole.spacing;
  const auto own = members.empty() ? whole : frame_of(places, members, whole.anchor, spacing);
  const auto& low = own.low;
  Point extent, whole_extent;
  for (std::size_t k = 0; k < D; ++k) {
    extent[k] = members.empty() ? 1 : own.high[k] - own.low[k] + 1;
    whole_extent[k] = whole.high[k] - whole.low[k] + 1;
  }

  // Rows run along the longest axis; the axis of the planes, whose margin is not shared, is the next longest.
  std::array<std::size_t, D> axes;
  std::iota(axes.begin(), axes.end(), std::size_t{0});
  std::ranges::stable_sort(axes, [&](auto a, auto b) { return whole_extent[a] > whole_extent[b]; });
  if constexpr (D == 3) std::swap(axes[1], axes[2]);

  const auto margin = static_cast<std::ptrdiff_t>(support / spacing);
  // A whole number of packs of records, which is how they are filled in.
  constexpr auto wide = static_cast<std::ptrdiff_t>(wide_pack_width), width = static_cast<std::ptrdiff_t>(pack_width);
  const auto pitch_of = [&](const Point& sizes) {
    return (std::max(sizes[axes[0]], wide) + 2 * margin + width - 1) / width * width;
  };
  double cells = static_cast<double>(pitch_of(whole_extent));
  for (std::size_t k = 1; k < D; ++k) {
    cells *= static_cast<double>(whole_extent[axes[k]] + margin);
    if (cells * least_filling > static_cast<double>(whole.count) + 1e3) return std::nullopt;
  }
  const auto pitch = pitch_of(extent);
  Point stride{};  // in rows
  std::ptrdiff_t rows = 1, reach = 0;
  for (std::size_t k = 1; k < D; ++k) {
    const auto axis = axes[k];
    stride[axis] = rows;
    reach += margin * rows;
    rows *= extent[axis] + margin;
  }

  Lattice lattice;
  lattice.pitch_ = static_cast<std::size_t>(pitch);
  lattice.margin_ = static_cast<std::size_t>(margin);
  lattice.planes_ = static_cast<std::size_t>(D > 1 ? extent[axes[D - 1]] : 1);
  lattice.plane_ = D > 1 ? stride[axes[D - 1]] : 0;
  lattice.first_row_ = reach;
  lattice.records_.assign(static_cast<std::size_t>((rows + 2 * reach) * pitch), nobody);
  for (const auto i : members) {
    const auto point = *point_of<D>(places[i], whole.anchor, spacing);
    std::ptrdiff_t row = reach;
    for (std::size_t k = 0; k < D; ++k) row += (point[k] - low[k]) * stride[k];
    const auto column = margin + point[axes[0]] - low[axes[0]];
    auto& record = lattice.records_[static_cast<std::size_t>(row * pitch + column)];
    if (record != nobody) return std::nullopt;
    record = i;
  }

  // Beams of much the same size, that begin where a pack of records does.
  const auto parts = [](std::size_t count, std::size_t most) { return (count + most - 1) / most; };
  const auto columns = static_cast<std::size_t>(std::max(extent[axes[0]], wide));
  const auto plane_rows = static_cast<std::size_t>(D == 3 ? extent[axes[1]] : 1);
  const auto across = parts(plane_rows, rows_of_beam), along = parts(columns, columns_of_beam);
  for (std::size_t a = 0; a < across; ++a)
    for (std::size_t b = 0; b < along; ++b) {
      const auto row = [&](std::size_t part) { return part * plane_rows / across; };
      const auto column = [&](std::size_t part) {
        return part == along ? columns : part * columns / along / pack_width * pack_width;
      };
      lattice.beams_.push_back({row(a), row(a + 1) - row(a), lattice.margin_ + column(b), column(b + 1) - column(b)});
    }

  Point step;
  step.fill(-margin);
  for (;;) {
    Neighbour neighbour{Vector<double, D>::zero(), {}};
    for (std::size_t k = 0; k < D; ++k) {
      neighbour.steps[k] = step[axes[D - 1 - k]];
      neighbour.x[static_cast<int>(k)] = -spacing * static_cast<double>(step[k]);
    }
    const double away = norm(neighbour.x);
    if (away > 0.0 && away < support) lattice.neighbours_.push_back(neighbour);
    std::size_t k = 0;
    while (k < D && step[k] == margin) step[k++] = -margin;
    if (k == D) break;
    ++step[k];
  }
  std::ranges::sort(lattice.neighbours_, {}, &Neighbour::steps);
  return lattice;
}

template class Lattice<1>;
template class Lattice<2>;
template class Lattice<3>;

}  // namespace tektite
