#pragma once

#include <cstdint>

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

/// Whether all lanes of `other` that hold are beyond the support of this h, by more than rounding: a pair then adds
/// zeros to all sums, bit for bit.
template <class Kernel, int D>
bool beyond_support(const Vector<Pack, D>& x, const Pack& h, const Pack::mask_type& other) {
  constexpr double beyond_rounding = 1.0 + 1e-9;
  const Pack reach = Pack(beyond_rounding * Kernel::support) * h;
  return none_of(other && dot(x, x) < reach * reach);
}
/// The same of all who are not in the particle's own place.
template <class Kernel, int D>
bool beyond_support(const Vector<Pack, D>& x, const Pack& h) {
  return beyond_support<Kernel>(x, h, dot(x, x) > Pack(0.0));
}

/// W at a distance, without a place.
template <class Kernel, int D>
Pack kernel_at(const Pack& distance, const Pack& h) {
  auto x = Vector<Pack, D>::zero();
  x[0] = distance;
  return KernelPair<Kernel, D>(x, h).value;
}

/// fⁿ of the artificial stress, f = W_ab/W(Δp): Young et al. (2021), eq. 10.
template <class Kernel, int D>
Pack closeness(const Pack& value, const Pack& spacing, const Pack& h, int exponent) {
  const Pack f = value / kernel_at<Kernel, D>(spacing, h);
  Pack power = f;
  for (int k = 1; k < exponent; ++k) power *= f;
  return power;
}

/// Lanes that hold a neighbour and not the particle itself, which fills a list up; a sum over kernel values needs it.
/// That by the place leaves out the image of a particle on a symmetry plane too, which is right where differences
/// between both are summed up: they are none.
template <int D>
Pack is_other(const Vector<Pack, D>& x) {
  return select(dot(x, x) > Pack(0.0), Pack(1.0), Pack(0.0));
}

/// The same by the index: that image has the other half of the particle, so a sum of the kernel's values alone needs
/// it.
inline Pack::mask_type is_other(std::size_t i, const std::uint32_t* j) {
  const Pack other([&](auto lane) { return static_cast<double>(j[static_cast<std::size_t>(lane)]); });
  return other != Pack(static_cast<double>(i));
}

}  // namespace tektite
