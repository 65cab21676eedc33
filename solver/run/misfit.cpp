#include "run/misfit.hpp"

#include <algorithm>
#include <cmath>
#include <vector>

#include "neighbours/cell_grid.hpp"
#include "parallel/for_each.hpp"
#include "parallel/sums.hpp"
#include "physics/kernels/kernel.hpp"
#include "run/lagrangian.hpp"
#include "run/particle_room.hpp"

namespace tektite {
namespace {

/// Of the smoothing length: how far the mean place of the neighbours may be from a particle that is surrounded.
constexpr double aside = 0.05;

/// What is found of all that count.
struct Found {
  std::size_t misfits = 0, untouched = 0;
  double sum = 0.0;  ///< Σ V W of the misfits
};

/// The Eulerian particles of a body that have not failed, and those that are near them.
template <int D>
class Surroundings {
 public:
  Surroundings(const Particles& particles, const Body& body) : particles_(particles) {
    const double* damage = particles.has(Field::damage) ? particles.scalars(Field::damage) : nullptr;
    double longest = 0.0;
    for (auto i = body.range.begin; i < body.range.end; ++i) {
      if (is_lagrangian(particles, i) || (damage && damage[i] >= 1.0)) continue;
      members_.push_back(i);
      x_.push_back(particles.vectors<D>(Field::position)[i]);
      room_.push_back(room_of(particles, body, i));
      longest = std::max(longest, particles.scalars(Field::smoothing_length)[i]);
    }
    if (!x_.empty()) grid_.build(x_, CubicSpline::support * longest);
  }

  Found find(const Range& range) const {
    std::vector<Look> looks(range.size());
    for_each(members_.size(), [&](std::size_t n) { looks[members_[n] - range.begin] = look(n); });
    const auto seen = [&](std::size_t i) { return looks[i - range.begin]; };
    return {count_over(particles_, range, [&](std::size_t i) { return seen(i).misfit; }),
            count_over(particles_, range, [&](std::size_t i) { return seen(i).untouched; }),
            sum_over<1>(particles_, range, [&](std::size_t i) { return std::array{seen(i).sum}; })[0]};
  }

 private:
  /// What is seen of one.
  struct Look {
    bool misfit = false, untouched = false;
    double sum = 0.0;  ///< Σ V W of a misfit
  };

  Look look(std::size_t n) const {
    const double h = particles_.scalars(Field::smoothing_length)[members_[n]];
    double sum = 0.0;
    std::size_t neighbours = 0;
    auto offset = Vector<double, D>{};
    for (const auto cell : grid_.around(grid_.cell_of(x_[n])))
      for (const auto m : grid_.members(cell)) {
        const auto apart = x_[m] - x_[n];
        const double part = room_[m] * kernel_value<CubicSpline, D>(norm(apart), h);
        sum += part;
        neighbours += m != n && part > 0.0 ? 1 : 0;
        offset += part * apart;
      }
    const bool untouched = neighbours == 0 && particles_.scalars(Field::pressure)[members_[n]] > 0.0;
    const bool near = std::pow(room_[n], 1.0 / D) < h;
    const bool misfit = near && norm(offset) <= aside * h && !(std::abs(sum - 1.0) < density_misfit);
    return {misfit, untouched, misfit ? sum : 0.0};
  }

  const Particles& particles_;
  std::vector<std::size_t> members_;
  std::vector<Vector<double, D>> x_;
  std::vector<double> room_;
  CellGrid<D> grid_;
};

Found found_in(const Particles& particles, const Body& body) {
  return particles.dimensions() == 1   ? Surroundings<1>(particles, body).find(body.range)
         : particles.dimensions() == 2 ? Surroundings<2>(particles, body).find(body.range)
                                       : Surroundings<3>(particles, body).find(body.range);
}

}  // namespace

Misfit misfit(const Particles& particles, const Body& body) {
  const auto found = found_in(particles, body);
  if (found.misfits == 0 && found.untouched == 0) return {};
  const auto all = static_cast<double>(size_of(particles, body)), misfits = static_cast<double>(found.misfits);
  return {misfits / all, found.misfits == 0 ? 1.0 : found.sum / misfits, static_cast<double>(found.untouched) / all};
}

}  // namespace tektite
