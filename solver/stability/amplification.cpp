#include "stability/amplification.hpp"

#include <Eigen/Eigenvalues>
#include <Eigen/SVD>

#include <algorithm>
#include <cmath>
#include <complex>
#include <map>
#include <numbers>

namespace tektite {
namespace {

using Complex = std::complex<double>;

/// Half the width of a block in which a change that reaches so many particles far does not feel the ends: what a step
/// makes of a particle depends on its neighbours and, through corrections, on theirs; and all that it depends on lies
/// as far again at most.
int needed_for(int reached, int support) { return std::min(2 * reached, reached + 2 * support); }

}  // namespace

Amplification::Amplification(const RunSettings& settings, const LatticeState& state, double share) {
  // What a step reaches is not known beforehand: the block grows until it has room for it.
  int needed = 4;
  for (int half_width = 0; half_width < needed;) {
    half_width = needed;
    LatticeBlock block(settings, state, half_width);
    time_step_ = share * block.stable_step();
    wave_speed_ = block.wave_speed();
    dimensions_ = block.dimensions();
    components_ = block.components();
    unknowns_ = components_.size() * static_cast<std::size_t>(block.columns());
    needed = measure(block);
  }
}

int Amplification::measure(LatticeBlock& block) {
  offsets_.clear();
  terms_.clear();
  std::map<std::array<int, 2>, std::size_t> known;
  const auto width = components_.size();
  int reached = 0;
  for (int column = 0; column < block.columns(); ++column)
    for (std::size_t c = 0; c < width; ++c) {
      const auto response = block.response(column, c, time_step_);
      for (std::size_t k = 0; k < response.size(); ++k) {
        if (response[k] == 0.0) continue;
        const auto cell = block.cell(k / width);
        const std::array<int, 2> offset{cell[0] - column, cell[1]};
        reached = std::max({reached, std::abs(offset[0]), std::abs(offset[1])});
        const auto found = known.try_emplace(offset, offsets_.size());
        if (found.second) offsets_.push_back(offset);
        const int to = ((cell[0] % block.columns()) + block.columns()) % block.columns();
        terms_.push_back({found.first->second, static_cast<std::size_t>(to) * width + k % width,
                          static_cast<std::size_t>(column) * width + c, response[k]});
      }
      if (const int needed = needed_for(reached, block.support()); needed > block.half_width()) return needed;
    }
  return 0;
}

Eigen::MatrixXcd Amplification::matrix(const Wave& wave) const {
  std::vector<Complex> phases;
  for (const auto& n : offsets_) phases.push_back(std::polar(1.0, -(wave[0] * n[0] + wave[1] * n[1])));
  const auto size = static_cast<Eigen::Index>(unknowns_);
  Eigen::MatrixXcd a = Eigen::MatrixXcd::Zero(size, size);
  for (const auto& term : terms_)
    a(static_cast<Eigen::Index>(term.row), static_cast<Eigen::Index>(term.column)) += term.value * phases[term.offset];
  return a;
}

Growth Amplification::growth(const Wave& wave) const {
  const Eigen::ComplexEigenSolver<Eigen::MatrixXcd> solver(matrix(wave), false);
  const double unit = LatticeBlock::spacing / (wave_speed_ * time_step_);
  Growth growth{-std::numeric_limits<double>::infinity(), 0.0};
  for (const auto& factor : solver.eigenvalues()) {
    growth.rate = std::max(growth.rate, unit * std::log(std::abs(factor)));
    if (std::abs(factor) > 0.5) growth.frequency = std::max(growth.frequency, unit * std::abs(std::arg(factor)));
  }
  return growth;
}

double Amplification::strain_share(const Wave& wave) const {
  const auto first = [this](Field field) {
    return std::ranges::find(components_, field, &StateComponent::field) - components_.begin();
  };
  const auto d = static_cast<Eigen::Index>(dimensions_);
  const Eigen::MatrixXcd l = matrix(wave).block(first(Field::velocity_gradient), first(Field::velocity), d * d, d);
  Eigen::MatrixXcd seen(d * d, d), exact(d * d, d);  // the symmetric part of what L each direction of velocity makes
  for (Eigen::Index i = 0; i < d; ++i)
    for (Eigen::Index j = 0; j < d; ++j)
      for (Eigen::Index v = 0; v < d; ++v) {
        const auto k = [&](Eigen::Index axis) { return wave[static_cast<std::size_t>(axis)]; };
        seen(i * d + j, v) = 0.5 * (l(i * d + j, v) + l(j * d + i, v));
        exact(i * d + j, v) = 0.5 * ((i == v ? k(j) : 0.0) + (j == v ? k(i) : 0.0));
      }
  const auto least = [](const Eigen::MatrixXcd& m) {
    return Eigen::JacobiSVD<Eigen::MatrixXcd>(m).singularValues().minCoeff();
  };
  return least(seen) / least(exact);
}

std::vector<Wave> waves_of(int dimensions, int steps, bool both_signs) {
  const double step = std::numbers::pi / steps;
  std::vector<Wave> waves;
  for (int x = 0; x <= steps; ++x)
    for (int y = dimensions == 1 ? 0 : both_signs ? -steps : 0; y <= (dimensions == 1 ? 0 : steps); ++y)
      if (x > 0 || y != 0) waves.push_back({step * x, step * y});
  return waves;
}

Fastest fastest_growth(const Amplification& amplification, const std::vector<Wave>& waves) {
  Fastest fastest{{-std::numeric_limits<double>::infinity(), 0.0}, {}};
  for (const auto& wave : waves)
    if (const auto growth = amplification.growth(wave); growth.rate > fastest.growth.rate) fastest = {growth, wave};
  return fastest;
}

}  // namespace tektite
