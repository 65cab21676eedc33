#pragma once
// How a model declares itself. A model is a plain struct with a name and its parameters; the same declaration feeds the
// reading of scenes, their checks and `tektite check`. A family of models is a std::variant; adding a model is one
// header and one line in the family's list.

#include <fmt/format.h>

#include <cmath>
#include <optional>
#include <string>
#include <string_view>
#include <tuple>
#include <variant>
#include <vector>

#include "core/document.hpp"

namespace tektite {

template <class Model>
struct Parameter {
  std::string_view key;
  double Model::*member;
  Dimension dimension;
  Limits limits;
  std::string_view meaning;
  double otherwise = std::nan("");  ///< NaN: the key has to be given
};

/// Two parameters of which the upper one has to lie above the lower one. A model that needs that of some has a static
/// ascending(), an array of these.
template <class Model>
struct Ascending {
  std::string_view lower_key;
  double Model::*lower;
  std::string_view upper_key;
  double Model::*upper;
  bool may_be_equal = false;
};

/// Throws InputError where ascending() does not hold.
template <class Model>
void check_order(const Model& model, const Section& section) {
  if constexpr (requires { Model::ascending(); }) {
    for (const auto& pair : Model::ascending()) {
      const Limits above{model.*pair.lower, limits::infinite, !pair.may_be_equal};
      if (!above.hold(model.*pair.upper))
        throw section.fault(std::string(pair.upper_key),
                            fmt::format("out of order: {} = {:g}", pair.lower_key, model.*pair.lower),
                            above.describe());
    }
  }
}

template <class Model>
Model read_parameters(Section& section) {
  Model model;
  for (const auto& parameter : Model::parameters()) {
    const std::string key(parameter.key);
    model.*parameter.member = std::isnan(parameter.otherwise)
                                  ? section.quantity(key, parameter.dimension, parameter.limits)
                                  : section.quantity(key, parameter.dimension, parameter.limits, parameter.otherwise);
  }
  check_order(model, section);
  return model;
}

template <class Variant>
struct Family;

template <class... Models>
struct Family<std::variant<Models...>> {
  static std::vector<std::string> names() { return {std::string(Models::name)...}; }

  /// Reads { model = NAME, parameters... }; throws InputError. Calls finish() on the section.
  static std::variant<Models...> read(Section& section) {
    const auto chosen = section.choice("model", names());
    std::optional<std::variant<Models...>> model;
    ((Models::name == chosen ? void(model = read_parameters<Models>(section)) : void()), ...);
    section.finish();
    return *model;
  }
};

}  // namespace tektite
