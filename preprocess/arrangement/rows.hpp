#pragma once
// Filling a shape row by row, in parallel: what all lattices share.

#include <functional>

#include "preprocess/arrangement/arrangement.hpp"

namespace tektite::preprocess {

/// The rows of a lattice, numbered in the order that the particles will have.
struct Rows {
  std::size_t count = 0;
  std::function<Row(std::size_t)> row;
};

/// The places on a share of the rows that lie inside the shape, row after row. Needs the places' own memory and a few
/// bytes for every stretch of neighbours in a row. Shows progress where standard error is a terminal.
std::vector<Point> fill_rows(const Shape& shape, const Rows& rows, double tolerance, const Share& share);

/// How many places all rows have.
std::size_t count_rows(const Shape& shape, const Rows& rows, double tolerance);

}  // namespace tektite::preprocess
