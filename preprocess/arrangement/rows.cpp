#include "preprocess/arrangement/rows.hpp"

#include <fmt/format.h>

#include <exception>
#include <numeric>

#include "core/error.hpp"
#include "preprocess/progress.hpp"

namespace tektite::preprocess {
namespace {

struct Stretch {
  std::size_t first = 0;
  std::size_t count = 0;
};

std::vector<Stretch> stretches(std::span<const std::uint8_t> inside) {
  std::vector<Stretch> result;
  for (std::size_t k = 0; k < inside.size(); ++k) {
    if (!inside[k]) continue;
    if (k == 0 || !inside[k - 1]) result.push_back({k, 0});
    ++result.back().count;
  }
  return result;
}

/// Calls work(row index, marks of its places) for these rows, on all threads; the first exception is passed on.
template <class Work>
void for_each_row(const Shape& shape, const Rows& rows, const Range& range, double tolerance, const Work& work) {
  std::exception_ptr failure;
  Progress progress("filling", range.size());
#pragma omp parallel
  {
    std::vector<std::uint8_t> inside;
#pragma omp for schedule(dynamic, 16)
    for (std::size_t k = range.begin; k < range.end; ++k) {
      try {
        const auto row = rows.row(k);
        inside.resize(row.count);
        shape.mark(row, tolerance, inside);
        work(k, inside);
        progress.advance();
      } catch (...) {
#pragma omp critical(tektite_rows_failure)
        failure = std::current_exception();
      }
    }
  }
  if (failure) std::rethrow_exception(failure);
}

/// Throws InputError where looking at every place would take too long or too much memory: a body may fill only a small
/// part of the box around it.
void check_places(const Rows& rows) {
  if (rows.count == 0) return;
  constexpr double most_places = 1e10;  // some minutes
  constexpr double most_rows = 2e8;     // some GB
  const auto count = static_cast<double>(rows.count);
  const auto places = count * static_cast<double>(rows.row(0).count);
  if (places > most_places || count > most_rows)
    throw InputError(fmt::format(
        "the box around the body has {:.2g} places in {:.2g} rows, more than {:.2g} or {:.2g}; is the unit right?",
        places, count, most_places, most_rows));
}

}  // namespace

std::vector<Point> fill_rows(const Shape& shape, const Rows& rows, double tolerance, const Share& share) {
  check_places(rows);
  const auto range = share.of(rows.count);
  std::vector<std::vector<Stretch>> kept(range.size());
  std::vector<std::size_t> first(range.size() + 1, 0);
  for_each_row(shape, rows, range, tolerance, [&](std::size_t row, std::span<const std::uint8_t> inside) {
    const auto k = row - range.begin;
    kept[k] = stretches(inside);
    for (const auto& stretch : kept[k]) first[k + 1] += stretch.count;
  });
  std::partial_sum(first.begin(), first.end(), first.begin());
  std::vector<Point> positions(first.back());
#pragma omp parallel for schedule(static)
  for (std::size_t k = 0; k < range.size(); ++k) {
    const auto row = rows.row(range.begin + k);
    auto next = first[k];
    for (const auto& stretch : kept[k])
      for (std::size_t i = 0; i < stretch.count; ++i) positions[next++] = row.at(stretch.first + i);
  }
  return positions;
}

std::size_t count_rows(const Shape& shape, const Rows& rows, double tolerance) {
  check_places(rows);
  std::vector<std::size_t> counts(rows.count, 0);
  for_each_row(shape, rows, {0, rows.count}, tolerance, [&](std::size_t k, std::span<const std::uint8_t> inside) {
    counts[k] = static_cast<std::size_t>(std::accumulate(inside.begin(), inside.end(), std::size_t{0}));
  });
  return std::accumulate(counts.begin(), counts.end(), std::size_t{0});
}

}  // namespace tektite::preprocess
