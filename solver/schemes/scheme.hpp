#pragma once
// What the run needs of a scheme: bring the particles from t to t + dt, and say how large dt may be.

#include <cmath>
#include <functional>
#include <limits>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "boundary/contact_settings.hpp"
#include "core/particles.hpp"
#include "core/scene.hpp"
#include "output/profile.hpp"
#include "parallel/halo.hpp"
#include "passes/time_step_limit.hpp"
#include "physics/kernels/kernel.hpp"
#include "physics/material.hpp"
#include "physics/viscosity/viscosity.hpp"
#include "schemes/adaptle_settings.hpp"

namespace tektite {

struct GodunovSettings;

struct SchemeSettings {
  std::string type;      ///< name in the registry
  double courant = 0.0;  ///< C in the time step limits
  std::string kernel;
  Viscosity viscosity;              ///< of eulerian, total-lagrangian and adaptle; none elsewhere
  bool corrected = false;           ///< mixed correction of kernels of the reference configuration
  bool corrected_eulerian = false;  ///< mixed correction of Eulerian kernels
  double correction_limit = std::numeric_limits<double>::infinity();  ///< C_f, of Eulerian kernels
  std::optional<ArtificialStress> artificial_stress;                  ///< of Eulerian kernels
  Conversion conversion;                                              ///< of total-Lagrangian particles
  std::optional<ContactSettings> contact;
  std::shared_ptr<const GodunovSettings> godunov;  ///< of the scheme godunov-split
  double smoothing_share = 0.0;                    ///< α_cs of the conservative smoothing
  bool adjoint_forces = false;                     ///< of msph: the adjoint of the strain rates, not the strong form
  std::optional<SymmetryPlane> anvil;              ///< a rigid smooth wall
  double hourglass_control = 0.0;                  ///< its modulus over the shear modulus; none where zero
};

/// Everything that a scheme is built from. The particles outlive the scheme.
struct SchemeSetup {
  Particles& particles;
  Profile& profile;
  const std::map<std::string, Material>& materials;
  SchemeSettings settings;
  std::vector<SymmetryPlane> symmetry;
  /// Takes the values that copies have of a field from their owners, where the particles are distributed.
  std::function<void(Field)> refresh = [](Field) {};
};

struct TimeStep {
  double dt = 0.0;
  StepLimit reason = StepLimit::end;
  std::int64_t particle = 0;  ///< id of the one that sets it
};

struct Ledger {
  double kinetic = 0.0, internal = 0.0, plastic = 0.0, viscous = 0.0;  ///< J
  double contact = 0.0;                                                ///< stored between bodies, J
  std::vector<double> momentum;                                        ///< kg m/s
  double hourglass = 0.0;  ///< work done against the control of such modes, J
  double total() const { return kinetic + internal + contact + hourglass; }
  /// What can go from one kind to another: the total, and with it what kinds above zero owe to those below it.
  double at_play() const {
    const double sizes = std::abs(kinetic) + std::abs(internal) + std::abs(contact) + std::abs(hourglass);
    return 0.5 * (sizes + std::abs(total()));
  }
};

/// A failure that has a name (docs/stability.md).
struct Warning {
  std::string name;
  std::string text;  ///< what was found, what it means, what may mend it
};

class Scheme {
 public:
  virtual ~Scheme() = default;

  /// From initial particles: fills every field that the scheme keeps, rates included.
  virtual void start() = 0;
  /// From saved particles: `state` is what save() put there.
  virtual void restore(const std::map<std::string, double>& state) = 0;
  virtual void save(std::map<std::string, double>& state) const = 0;

  virtual void step(double dt) = 0;

  /// What a rank needs of the others' particles, so that a step gives its own what it would with all of them: the pairs
  /// of every sweep, one behind the other. `state` is what save() put there, or nothing before start().
  virtual Halos halos(const std::map<std::string, double>& state) const = 0;
  /// Where particles are distributed, who takes a step of dt asks before it whether neighbours have to be searched
  /// anew. Then the search begins: with the places that it is for, and with the reach; save() has them, and restore()
  /// ends it by the list.
  virtual bool search_is_due(double dt) = 0;
  virtual void begin_search(double dt) = 0;
  /// There a step goes in parts, between which copies come from their owners, and another search may begin, for a step
  /// of 0.
  virtual int parts() const { return 1; }
  virtual void step_part(int, double dt) { step(dt); }
  /// Whether the last step has changed who is near whom in the sums, so that its end takes a search, of a step of 0.
  virtual bool search_is_left() const { return false; }

  /// The largest stable time step; zero where the state is not sane, with the particle.
  virtual TimeStep stable_step() const = 0;
  virtual Ledger ledger() = 0;
  /// Whether particles of different bodies act on each other.
  virtual bool in_contact() const = 0;
  /// What a user should know about its particles now; may be empty.
  virtual std::string remark() const { return {}; }
  /// What a user should know when it ends; may be empty.
  virtual std::string closing_remark() const { return {}; }
  /// What it knows of its own failures so far.
  virtual std::vector<Warning> warnings() const { return {}; }
  /// Bytes that the scheme holds beside the fields.
  virtual std::size_t memory() const = 0;
};

/// Names of all schemes.
std::vector<std::string> scheme_names();

/// Reads the solver's tables [scheme], [viscosity], [contact] of a scene.
SchemeSettings read_scheme(Section& root, const Scene& scene);

/// Throws InputError where the scheme does not support the space.
std::unique_ptr<Scheme> make_scheme(const SchemeSetup& setup);

}  // namespace tektite
