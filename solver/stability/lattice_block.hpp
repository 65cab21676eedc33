#pragma once
// A piece of a uniform lattice with a scheme at work on it, large enough for its middle not to feel its ends: what a
// linear analysis of the real code perturbs and steps.

#include <array>
#include <map>
#include <memory>
#include <string>
#include <vector>

#include "output/profile.hpp"
#include "run/run_settings.hpp"

namespace tektite {

/// The state about which a scheme is linearised: the same everywhere, at rest.
struct LatticeState {
  std::string material;
  double ratio = 0.0;               ///< h/δ of the lattice before it is deformed
  std::vector<double> deformation;  ///< F, row-major, D x D: places, density and for kernels of the reference
                                    ///< configuration the stress follow from it
};

/// F without shear that brings a material of specific energy zero to a mean stress (tension positive, Pa). Throws
/// InputError where its equation of state reaches it between half and twice the reference density nowhere.
std::vector<double> deformation_for(const Material& material, int dimensions, double stress);

/// A number of a particle that a step of some scheme starts from, and what makes it of order one.
struct StateComponent {
  Field field;
  int component = 0;
  double scale = 1.0;  ///< SI, from δ, ρ and the wave speed c
};

class LatticeBlock {
 public:
  static constexpr double spacing = 1e-3;  ///< δ before the deformation, m: no growth times δ/c depends on it

  /// 2 half_width + columns() particles along x and 2 half_width + 1 along y. Throws InputError where the scheme does
  /// not support the space, or the space is no straight line or plane.
  LatticeBlock(const RunSettings& settings, const LatticeState& state, int half_width);

  /// The lattice repeats itself after as many columns of particles: one, or for the scheme adaptle as many as make a
  /// strip of total-Lagrangian and one of Eulerian particles, each as wide as two supports of the kernel.
  int columns() const { return columns_; }
  int half_width() const { return half_width_; }
  int support() const { return support_; }  ///< of the kernel, in particles
  int dimensions() const { return particles_.dimensions(); }
  double stable_step() const { return stable_step_; }  ///< of the undeformed lattice, s
  double wave_speed() const { return wave_speed_; }    ///< of the undeformed lattice, m/s
  const std::vector<StateComponent>& components() const { return components_; }

  /// What a step of dt makes of a particle, over what it was changed by: a row for each particle, a column for each
  /// component. `column` is that of the changed particle in the middle of the block. The central difference of
  /// fourth order: of four steps that start from the same state.
  std::vector<double> response(int column, std::size_t component, double dt);

  /// Place of a particle in the lattice, from the first of the middle columns.
  std::array<int, 2> cell(std::size_t particle) const { return cells_[particle]; }
  std::size_t count() const { return particles_.count(); }

 private:
  Particles make_particles(const RunSettings& settings, const LatticeState& state) const;
  void deform(const std::vector<double>& f);
  void choose_components();
  std::vector<double> state_after(std::size_t particle, const StateComponent& changed, double change, double dt);

  int columns_, half_width_, support_;
  std::map<std::string, Material> materials_;
  Particles particles_;
  Profile profile_;
  std::unique_ptr<Scheme> scheme_;
  double stable_step_ = 0.0, wave_speed_ = 0.0;
  std::vector<StateComponent> components_;
  std::vector<std::array<int, 2>> cells_;
  std::vector<std::size_t> middle_;  ///< the particle of each column
  Particles base_;
};

}  // namespace tektite
