#pragma once

#include <optional>
#include <type_traits>
#include <variant>

#include "physics/material.hpp"

namespace tektite {

/// In Pa, at the beginning of plastic flow at this rate; nothing where the material does not flow, or bears what the
/// pressure lets it bear.
inline std::optional<double> flow_stress(const Material& material, double rate) {
  return std::visit(
      [rate](const auto& model) -> std::optional<double> {
        using Model = std::decay_t<decltype(model)>;
        if constexpr (Model::kind.yields && !Model::kind.crushes) {
          FlowState state;
          state.plastic_strain_rate = rate;
          if constexpr (requires { model.room_temperature; }) state.temperature = model.room_temperature;
          return model.flow_stress(state);
        } else {
          return std::nullopt;
        }
      },
      material.strength);
}

}  // namespace tektite
