#pragma once
// Errors at a cost: which runs are worth their cost, and what an error costs. Pure functions.

#include <cstddef>
#include <optional>
#include <span>
#include <vector>

namespace tektite {

/// A run as it is judged: what it cost, in s of processor time, and how wrong it is.
struct Judged {
  double cost = 0.0;   ///< positive
  double error = 0.0;  ///< not negative
};

/// The runs that no other run beats: none is as cheap and as right, and better in one of the two. By rising cost. Of
/// equal runs the first is named.
std::vector<std::size_t> pareto_front(std::span<const Judged> runs);

/// What an error costs on a line of runs.
struct CostOfError {
  double cost = 0.0;
  bool at_most = false;  ///< the cheapest run that reaches the error has no worse neighbour: it may cost less
};

/// The least cost at which a line, run after run, reaches `error`: straight between two runs in the logarithms of cost
/// and error. Nullopt where no run reaches it.
std::optional<CostOfError> cost_of_error(std::span<const Judged> line, double error);

}  // namespace tektite
