#include "run/watch.hpp"

#include <fmt/format.h>

#include <cmath>

#include "core/kernel_type.hpp"
#include "neighbours/cell_grid.hpp"

namespace tektite {
namespace {

/// Kernels of the reference configuration do not let go of their neighbours, however near these come.
std::vector<std::size_t> eulerian_of(const Particles& particles, const Body& body) {
  const bool all = !particles.has(Field::reference_position);
  std::vector<std::size_t> chosen;
  for (std::size_t i = body.range.begin; i < body.range.end; ++i)
    if (all || particles.integers(Field::kernel_type)[i] == static_cast<std::int64_t>(KernelType::eulerian))
      chosen.push_back(i);
  return chosen;
}

template <int D>
std::size_t count_clumped(const Particles& particles, const Body& body, double density) {
  const auto chosen = eulerian_of(particles, body);
  if (chosen.empty()) return 0;
  const auto* places = particles.vectors<D>(Field::position);
  std::vector<Vector<double, D>> x;
  std::vector<double> near;  // per particle, m
  double farthest = 0.0;
  for (const auto i : chosen) {
    x.push_back(places[i]);
    near.push_back(clumped_distance * body.spacing * std::pow(density / particles.scalars(Field::density)[i], 1.0 / D));
    farthest = std::max(farthest, near.back());
  }
  CellGrid<D> grid;
  grid.build(x, farthest);
  std::size_t clumped = 0;
  for (std::size_t n = 0; n < x.size(); ++n) {
    bool found = false;
    for (const auto cell : grid.around(grid.cell_of(x[n])))
      for (const auto m : grid.members(cell))
        found = found || (m != n && norm(x[m] - x[n]) < std::min(near[m], near[n]));
    clumped += found ? 1 : 0;
  }
  return clumped;
}

}  // namespace

double clumped_part(const Particles& particles, const Body& body, double density) {
  const auto count = particles.dimensions() == 1   ? count_clumped<1>(particles, body, density)
                     : particles.dimensions() == 2 ? count_clumped<2>(particles, body, density)
                                                   : count_clumped<3>(particles, body, density);
  return static_cast<double>(count) / static_cast<double>(body.range.size());
}

std::vector<Warning> Watch::look(const Particles& particles, const std::map<std::string, Material>& materials) {
  std::vector<Warning> found;
  for (const auto& body : particles.bodies()) {
    const double part = clumped_part(particles, body, materials.at(body.material).density);
    if (part <= clumped_share || !told_.insert("clumping " + body.name).second) continue;
    names_.insert("clumping");
    found.push_back(
        {"clumping",
         fmt::format("{:.0f} % of the particles of {} lie nearer to another one than a third of their spacing, as the "
                     "tensile instability leaves them: cracks and fragments there are not the material's; "
                     "total-Lagrangian kernels or scheme.artificial_stress may mend it",
                     100.0 * part, body.name)});
  }
  return found;
}

}  // namespace tektite
