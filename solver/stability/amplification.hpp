#pragma once
// One step of the real code as a linear map of plane waves on a lattice (von Neumann's analysis, by differences). A
// lattice is the same seen from each of its particles: so what a change of one particle does to all others in a step,
// G(r), says what a step does to any wave a exp(i κ·n), n the place in the lattice: A(κ) = Σ_n G(n) exp(-i κ·n). Its
// eigenvalues are the factors by which the modes of that wave vector grow in a step.
//
// Where a step is not differentiable at rest (the viscosity's switch, limiters, the switch of artificial stress), the
// difference of both signs stands for both.

#include <Eigen/Core>

#include <array>
#include <vector>

#include "stability/lattice_block.hpp"

namespace tektite {

/// κ = (k_x δ, k_y δ), radians from one particle of the undeformed lattice to the next.
using Wave = std::array<double, 2>;

/// How the modes of a wave grow and how fast those swing that are not gone in a step: the largest of each, times δ/c.
struct Growth {
  double rate = 0.0;       ///< ln|λ|/Δt · δ/c
  double frequency = 0.0;  ///< |arg λ|/Δt · δ/c
};

class Amplification {
 public:
  /// For time steps of `share` times that which the scheme takes on the undeformed lattice.
  Amplification(const RunSettings& settings, const LatticeState& state, double share = 1.0);

  /// A(κ) for all components of all columns, scaled to be of order one.
  Eigen::MatrixXcd matrix(const Wave& wave) const;
  Growth growth(const Wave& wave) const;
  /// How much of the strain rate of a wave of velocity the scheme sees in its least seen direction, over what there is:
  /// one in the limit of long waves, zero for a mode that costs no energy. Only of lattices of one column.
  double strain_share(const Wave& wave) const;

  double time_step() const { return time_step_; }    ///< s
  double wave_speed() const { return wave_speed_; }  ///< c of the undeformed lattice, m/s
  int dimensions() const { return dimensions_; }

 private:
  /// Zero, or the half width of the block that is needed where this one is too small.
  int measure(LatticeBlock& block);

  struct Term {
    std::size_t offset;  ///< in `offsets_`
    std::size_t row, column;
    double value;
  };
  int dimensions_ = 0;
  std::size_t unknowns_ = 0;
  double time_step_ = 0.0, wave_speed_ = 0.0;
  std::vector<StateComponent> components_;
  std::vector<std::array<int, 2>> offsets_;
  std::vector<Term> terms_;
};

/// Wave vectors with κ_x and κ_y from zero to π in `steps` steps each, without zero itself; where `both_signs`, those
/// with negative κ_y too, which are others where the lattice is sheared.
std::vector<Wave> waves_of(int dimensions, int steps, bool both_signs = false);

/// The wave that grows most.
struct Fastest {
  Growth growth;
  Wave wave{};
};
Fastest fastest_growth(const Amplification& amplification, const std::vector<Wave>& waves);

}  // namespace tektite
