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

/// What a flow stress may depend on, of one particle or of several side by side (core/pack.hpp).
template <class N = double>
struct FlowState {
  N plastic_strain = 0.0;
  N plastic_strain_rate = 0.0;  ///< 1/s
  N temperature = 0.0;          ///< K
  N pressure = 0.0;             ///< Pa
  N damage = 0.0;               ///< 1: failed
};

/// A flow stress Y and how it grows with the plastic strain Δε of a step.
template <class N>
struct Flow {
  N stress;  ///< Pa
  N slope;   ///< dY/dΔε, Pa
};

}  // namespace tektite
