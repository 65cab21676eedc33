#pragma once
// What a pair pass reads of its records: a particle's own numbers in every lane, and a member of four neighbours.

#include <algorithm>
#include <cstdint>

#include "core/pack.hpp"
#include "core/tensor.hpp"

namespace tektite {

/// The same number in every lane, for each component.
template <class T = Pack, int D>
[[gnu::always_inline]] inline Vector<T, D> broadcast(const Vector<double, D>& v) {
  Vector<T, D> result;
  for (int k = 0; k < D; ++k) result[k] = v[k];
  return result;
}
template <int D>
[[gnu::always_inline]] inline Tensor<Pack, D> broadcast(const Tensor<double, D>& t) {
  Tensor<Pack, D> result;
  for (int k = 0; k < D * D; ++k) result.c[k] = t.c[k];
  return result;
}
template <std::size_t count>
[[gnu::always_inline]] inline void broadcast(const double (&from)[count], Pack (&to)[count]) {
  for (std::size_t k = 0; k < count; ++k) to[k] = from[k];
}

/// number(record), a reference to one, of the four neighbours in j. Record: a struct of doubles. Where it has the room,
/// the row of four numbers that holds this one is loaded of each neighbour and all four rows are turned; the compiler
/// does that once for all numbers of a row, which takes a third less of the time of a pass than number by number.
template <class Record, class Number>
[[gnu::always_inline]] inline Pack gathered_by(const Record* records, const std::uint32_t* j, const Number& number) {
  constexpr std::size_t numbers = sizeof(Record) / sizeof(double);
  if constexpr (numbers < pack_width) {
    return Pack([&](auto lane) { return number(records[j[static_cast<std::size_t>(lane)]]); });
  } else {
    static constexpr Record any{};
    const auto k = static_cast<std::size_t>(&number(any) - reinterpret_cast<const double*>(&any));
    const std::size_t row = std::min(k / pack_width * pack_width, numbers - pack_width);
    const double* place[pack_width];
    for (std::size_t lane = 0; lane < pack_width; ++lane)
      place[lane] = reinterpret_cast<const double*>(&records[j[lane]]) + row;
    Pack turned[pack_width];
    gather<1>(place, turned);
    return turned[k - row];
  }
}

/// What a pass gets that reads such records: a Pack of neighbours, or a WidePack of transposed ones.
template <class Records>
struct NumberOf {
  using Type = Pack;
};

/// A member of the four neighbours in j, for each component. Records are a pointer to them and j four indices; or
/// transposed ones and a cell (passes/transposed.hpp).
template <class Records, class Index, class Owner>
[[gnu::always_inline]] inline auto gathered(const Records& records, Index j, double Owner::*member) {
  return gathered_by(records, j, [=](const Owner& r) -> const double& { return r.*member; });
}
template <class Records, class Index, class Owner, int D>
[[gnu::always_inline]] inline auto gathered(const Records& records, Index j, Vector<double, D> Owner::*member) {
  Vector<typename NumberOf<Records>::Type, D> result;
  for (int k = 0; k < D; ++k)
    result[k] = gathered_by(records, j, [=](const Owner& r) -> const double& { return (r.*member)[k]; });
  return result;
}
template <class Records, class Index, class Owner, int D>
[[gnu::always_inline]] inline auto gathered(const Records& records, Index j, Tensor<double, D> Owner::*member) {
  Tensor<typename NumberOf<Records>::Type, D> result;
  for (int k = 0; k < D * D; ++k)
    result.c[k] = gathered_by(records, j, [=](const Owner& r) -> const double& { return (r.*member).c[k]; });
  return result;
}
template <class Records, class Index, class Owner, std::size_t count>
[[gnu::always_inline]] inline void gather_into(Pack (&to)[count], const Records& records, Index j,
                                               double (Owner::*member)[count]) {
  for (std::size_t k = 0; k < count; ++k)
    to[k] = gathered_by(records, j, [=](const Owner& r) -> const double& { return (r.*member)[k]; });
}

/// A member of the particle itself, in every lane.
template <class Record, class Owner>
[[gnu::always_inline]] inline Pack own(const Record* records, std::size_t i, double Owner::*member) {
  return records[i].*member;
}
template <class Record, class Owner, class Member>
[[gnu::always_inline]] inline auto own(const Record* records, std::size_t i, Member Owner::*member) {
  return broadcast(records[i].*member);
}

/// The first `numbers` numbers of four records, turned: out[k] holds the k-th of each.
template <std::size_t numbers, class Record>
auto gather_records(const Record* records, const std::uint32_t* j) {
  constexpr std::size_t rows = (numbers + pack_width - 1) / pack_width;
  static_assert(rows * pack_width * sizeof(double) <= sizeof(Record));
  const double* place[pack_width];
  for (std::size_t k = 0; k < pack_width; ++k) place[k] = &records[j[k]].x[0];
  struct {
    Pack number[rows * pack_width];
  } turned;
  gather<rows>(place, turned.number);
  return turned;
}

}  // namespace tektite
