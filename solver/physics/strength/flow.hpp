#pragma once

namespace tektite {

/// What a strength model does; decides which fields a material needs and which branches its formulas have.
struct StrengthKind {
  bool shears;   ///< carries deviatoric stress
  bool yields;   ///< has a flow stress
  bool hardens;  ///< its flow stress depends on the plastic strain or its rate; it has a flow_in(step, state), which
                 ///< gives the Flow where the strain grows by Δε within the step and the rate is Δε/step
  bool heats;    ///< has a temperature that plastic work raises
  bool crushes = false;  ///< its flow stress depends on pressure and damage, and tells what failed material bears
};

/// What a flow stress may depend on.
struct FlowState {
  double plastic_strain = 0.0;
  double plastic_strain_rate = 0.0;  ///< 1/s
  double temperature = 0.0;          ///< K
  double pressure = 0.0;             ///< Pa
  double damage = 0.0;               ///< 1: failed
};

/// A flow stress Y and how it grows with the plastic strain Δε of a step.
struct Flow {
  double stress;  ///< Pa
  double slope;   ///< dY/dΔε, Pa
};

}  // namespace tektite
