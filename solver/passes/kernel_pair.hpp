#pragma once

#include "core/pack.hpp"
#include "core/tensor.hpp"

namespace tektite {

/// Kernel and gradient between two places; h in m.
template <class Kernel, int D>
struct KernelPair {
  Pack value;             ///< W
  Vector<Pack, D> slope;  ///< ∇W at the first, along X_a - X_b

  KernelPair(const Vector<Pack, D>& x, const Pack& h) {
    using std::experimental::sqrt;
    const Pack one_over_h = Pack(1.0) / h;
    const Pack q = sqrt(dot(x, x)) * one_over_h;
    Pack constant = Pack(Kernel::template normalisation<D>());
    for (int k = 0; k < D; ++k) constant *= one_over_h;
    const auto near = q < Pack(Kernel::support);
    value = select(near, constant * Kernel::shape(q), Pack(0.0));
    const Pack factor = select(near, constant * one_over_h * one_over_h * Kernel::slope_over_q(q), Pack(0.0));
    for (int k = 0; k < D; ++k) slope[k] = factor * x[k];
  }
};

/// Lanes that hold a neighbour and not the particle itself, which fills a list up; a sum over kernel values needs it.
template <int D>
Pack is_other(const Vector<Pack, D>& x) {
  return select(dot(x, x) > Pack(0.0), Pack(1.0), Pack(0.0));
}

}  // namespace tektite
