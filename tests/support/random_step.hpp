#pragma once
// Random steps of a strength model, the same in every run.

#include <cmath>
#include <random>

#include "core/tensor.hpp"
#include "physics/strength/advance_deviator.hpp"

namespace tektite::test {

class Random {
 public:
  explicit Random(unsigned seed) : generator_(seed) {}

  double between(double low, double high) { return std::uniform_real_distribution<double>(low, high)(generator_); }

  /// Evenly spread over the powers between.
  double magnitude(double low, double high) { return std::exp(between(std::log(low), std::log(high))); }

  /// A velocity gradient with spin, whose components are at most `largest` in 1/s.
  template <int D>
  Tensor<double, D> gradient(double largest) {
    Tensor<double, D> l;
    for (auto& component : l.c) component = between(-largest, largest);
    return l;
  }

  template <int D>
  Symmetric<double, D> symmetric(double largest) {
    Symmetric<double, D> s;
    for (auto& component : s.c) component = between(-largest, largest);
    return s;
  }

 private:
  std::mt19937 generator_;
};

/// The state of a material that nothing has happened to.
template <int D, class Model>
DeviatorState<D> start_of(const Model& model) {
  DeviatorState<D> state{Symmetric<double, D>::zero(), 0.0, 0.0, 0.0};
  if constexpr (Model::kind.heats) state.temperature = model.room_temperature;
  return state;
}

template <int D>
Tensor<double, D> without_spin(const Tensor<double, D>& l) {
  Tensor<double, D> symmetric;
  for (int i = 0; i < D; ++i)
    for (int j = 0; j < D; ++j) symmetric(i, j) = 0.5 * (l(i, j) + l(j, i));
  return symmetric;
}

template <int D>
Tensor<double, D> negative(Tensor<double, D> l) {
  for (auto& component : l.c) component = -component;
  return l;
}

}  // namespace tektite::test
