#include "core/particles.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <stdexcept>

namespace tektite {
namespace {

std::size_t slot(Field field) { return static_cast<std::size_t>(field); }

void expect(bool allocated, Field field) {
  if (!allocated) throw std::logic_error(fmt::format("field {} is not allocated", info(field).name));
}

void expect_size(std::size_t given, std::size_t wanted, Field field) {
  if (given != wanted)
    throw std::logic_error(fmt::format("field {} has {} numbers where {} belong", info(field).name, given, wanted));
}

template <class T>
void permute_column(std::vector<T>& column, std::span<const std::uint32_t> order, std::size_t width) {
  std::vector<T> sorted(column.size());
#pragma omp parallel for schedule(static)
  for (std::size_t k = 0; k < order.size(); ++k)
    std::copy_n(column.data() + order[k] * width, width, sorted.data() + k * width);
  column = std::move(sorted);
}

}  // namespace

Particles::Particles(Space space, std::vector<Body> bodies) : space_(space), bodies_(std::move(bodies)) {
  for (const auto& body : bodies_) count_ = std::max(count_, body.range.end);
}

void Particles::allocate(Field field, std::size_t spare) {
  allocated_[slot(field)] = true;
  const std::size_t size = (count_ + spare) * static_cast<std::size_t>(components(field));
  if (info(field).rank == Rank::integer)
    integers_[slot(field)].resize(size);
  else
    reals_[slot(field)].resize(size);
}

void Particles::adopt(Field field, std::vector<double> values) {
  expect_size(values.size(), count_ * static_cast<std::size_t>(components(field)), field);
  allocated_[slot(field)] = true;
  reals_[slot(field)] = std::move(values);
}

void Particles::adopt(Field field, std::vector<std::int64_t> values) {
  expect_size(values.size(), count_, field);
  allocated_[slot(field)] = true;
  integers_[slot(field)] = std::move(values);
}

void Particles::release(Field field) {
  allocated_[slot(field)] = false;
  reals_[slot(field)] = std::vector<double>();  // {} would leave it as large as it is
  integers_[slot(field)] = std::vector<std::int64_t>();
}

bool Particles::has(Field field) const { return allocated_[slot(field)]; }

std::span<double> Particles::reals(Field field) {
  expect(allocated_[slot(field)], field);
  return reals_[slot(field)];
}

std::span<const double> Particles::reals(Field field) const {
  expect(allocated_[slot(field)], field);
  return reals_[slot(field)];
}

std::span<std::int64_t> Particles::integers(Field field) {
  expect(allocated_[slot(field)], field);
  return integers_[slot(field)];
}

std::span<const std::int64_t> Particles::integers(Field field) const {
  expect(allocated_[slot(field)], field);
  return integers_[slot(field)];
}

void Particles::permute(std::span<const std::uint32_t> order) {
  for (const auto& row : field_table) {
    if (!has(row.field) || row.keep == Keep::scratch) continue;
    const auto width = static_cast<std::size_t>(components(row.field));
    if (row.rank == Rank::integer)
      permute_column(integers_[slot(row.field)], order, width);
    else
      permute_column(reals_[slot(row.field)], order, width);
  }
}

std::size_t Particles::memory() const {
  std::size_t bytes = 0;
  for (const auto& column : reals_) bytes += column.size() * sizeof(double);
  for (const auto& column : integers_) bytes += column.size() * sizeof(std::int64_t);
  return bytes;
}

}  // namespace tektite
