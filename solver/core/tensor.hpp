#pragma once
// Small vectors and tensors, sized by the number of coordinates D, for double and for Pack (core/pack.hpp) alike.
// Eigen has no symmetric tensor that keeps the out-of-plane normal component beside D-dimensional shear, which is what
// a plane scene carries, so these few lines stand here; eigenvalues and linear systems use Eigen.

#include <array>
#include <cmath>

#include "core/space.hpp"

namespace tektite {

template <class T, int D>
struct Vector {
  T c[D];

  T& operator[](int k) { return c[k]; }
  const T& operator[](int k) const { return c[k]; }

  static Vector zero() {
    Vector v;
    for (int k = 0; k < D; ++k) v.c[k] = T(0.0);
    return v;
  }
  Vector& operator+=(const Vector& b) {
    for (int k = 0; k < D; ++k) c[k] += b.c[k];
    return *this;
  }
};

template <class T, int D>
Vector<T, D> operator+(Vector<T, D> a, const Vector<T, D>& b) {
  return a += b;
}
template <class T, int D>
Vector<T, D> operator-(Vector<T, D> a, const Vector<T, D>& b) {
  for (int k = 0; k < D; ++k) a[k] -= b[k];
  return a;
}
template <class T, int D>
Vector<T, D> operator*(const T& s, Vector<T, D> a) {
  for (int k = 0; k < D; ++k) a[k] = s * a[k];
  return a;
}
template <class T, int D>
T dot(const Vector<T, D>& a, const Vector<T, D>& b) {
  T sum = a[0] * b[0];
  for (int k = 1; k < D; ++k) sum += a[k] * b[k];
  return sum;
}
template <class T, int D>
T norm(const Vector<T, D>& a) {
  using std::sqrt;
  return sqrt(dot(a, a));
}

/// Row-major D x D tensor; a velocity gradient has L[i, j] = dv_i/dx_j.
template <class T, int D>
struct Tensor {
  T c[D * D];

  T& operator()(int i, int j) { return c[i * D + j]; }
  const T& operator()(int i, int j) const { return c[i * D + j]; }

  static Tensor zero() {
    Tensor t;
    for (int k = 0; k < D * D; ++k) t.c[k] = T(0.0);
    return t;
  }
  Tensor& operator+=(const Tensor& b) {
    for (int k = 0; k < D * D; ++k) c[k] += b.c[k];
    return *this;
  }
};

template <class T, int D>
Tensor<T, D> operator+(Tensor<T, D> a, const Tensor<T, D>& b) {
  return a += b;
}
template <class T, int D>
Tensor<T, D> operator-(Tensor<T, D> a, const Tensor<T, D>& b) {
  for (int k = 0; k < D * D; ++k) a.c[k] -= b.c[k];
  return a;
}
template <class T, int D>
Tensor<T, D> operator*(const T& s, Tensor<T, D> a) {
  for (auto& component : a.c) component *= s;
  return a;
}

/// a += u ⊗ v
template <class T, int D>
void add_outer(Tensor<T, D>& a, const Vector<T, D>& u, const Vector<T, D>& v) {
  for (int i = 0; i < D; ++i)
    for (int j = 0; j < D; ++j) a(i, j) += u[i] * v[j];
}

template <class T, int D>
T trace(const Tensor<T, D>& a) {
  T sum = a(0, 0);
  for (int k = 1; k < D; ++k) sum += a(k, k);
  return sum;
}

/// Symmetric tensor with components xx yy zz (xy (yz zx)).
template <class T, int D>
struct Symmetric {
  static constexpr int size = symmetric_components(D);
  T c[size];

  /// Index in c of component (i, j); i == j may exceed D (the normal components across the space).
  static constexpr int index(int i, int j) {
    if (i == j) return i;
    return D == 2 || i + j == 1 ? 3 : (i + j == 3 ? 4 : 5);
  }
  T& operator()(int i, int j) { return c[index(i, j)]; }
  const T& operator()(int i, int j) const { return c[index(i, j)]; }

  static Symmetric zero() {
    Symmetric s;
    for (int k = 0; k < size; ++k) s.c[k] = T(0.0);
    return s;
  }
  Symmetric& operator+=(const Symmetric& b) {
    for (int k = 0; k < size; ++k) c[k] += b.c[k];
    return *this;
  }
};

template <class T, int D>
Symmetric<T, D> operator+(Symmetric<T, D> a, const Symmetric<T, D>& b) {
  return a += b;
}
template <class T, int D>
Symmetric<T, D> operator-(Symmetric<T, D> a, const Symmetric<T, D>& b) {
  for (int k = 0; k < a.size; ++k) a.c[k] -= b.c[k];
  return a;
}
template <class T, int D>
Symmetric<T, D> operator*(const T& s, Symmetric<T, D> a) {
  for (int k = 0; k < a.size; ++k) a.c[k] = s * a.c[k];
  return a;
}

template <class T, int D>
T trace(const Symmetric<T, D>& a) {
  return a.c[0] + a.c[1] + a.c[2];
}

/// a : b over all nine components.
template <class T, int D>
T contract(const Symmetric<T, D>& a, const Symmetric<T, D>& b) {
  T sum = a.c[0] * b.c[0] + a.c[1] * b.c[1] + a.c[2] * b.c[2];
  for (int k = 3; k < a.size; ++k) sum += T(2.0) * (a.c[k] * b.c[k]);
  return sum;
}

/// a v, within the D coordinates.
template <class T, int D>
Vector<T, D> operator*(const Symmetric<T, D>& a, const Vector<T, D>& v) {
  Vector<T, D> result;
  for (int i = 0; i < D; ++i) {
    result[i] = a(i, 0) * v[0];
    for (int j = 1; j < D; ++j) result[i] += a(i, j) * v[j];
  }
  return result;
}

template <class T, int D>
Symmetric<T, D> deviator(Symmetric<T, D> a) {
  const T mean = trace(a) / T(3.0);
  for (int k = 0; k < 3; ++k) a.c[k] -= mean;
  return a;
}

/// Rate of deformation: the symmetric part of L; components across the space are zero.
template <class T, int D>
Symmetric<T, D> symmetric_part(const Tensor<T, D>& l) {
  auto d = Symmetric<T, D>::zero();
  for (int i = 0; i < D; ++i) {
    d(i, i) = l(i, i);
    for (int j = i + 1; j < D; ++j) d(i, j) = T(0.5) * (l(i, j) + l(j, i));
  }
  return d;
}

/// Von Mises equivalent of a deviator s: √(3/2 s:s).
template <class T, int D>
T von_mises(const Symmetric<T, D>& s) {
  using std::sqrt;
  return sqrt(T(1.5) * contract(s, s));
}

}  // namespace tektite
