#include "postprocess/accuracy/cost.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

namespace tektite {
namespace {

/// Where the straight line from `wrong` to `right`, in logarithms, has this error.
double cost_between(const Judged& wrong, const Judged& right, double error) {
  if (right.error <= 0.0) return right.cost;  // no logarithm
  const double share = std::log(wrong.error / error) / std::log(wrong.error / right.error);
  return wrong.cost * std::pow(right.cost / wrong.cost, share);
}

}  // namespace

std::vector<std::size_t> pareto_front(std::span<const Judged> runs) {
  std::vector<std::size_t> order(runs.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::ranges::stable_sort(order, [&](std::size_t a, std::size_t b) {
    return runs[a].cost != runs[b].cost ? runs[a].cost < runs[b].cost : runs[a].error < runs[b].error;
  });
  std::vector<std::size_t> front;
  double least = std::numeric_limits<double>::infinity();
  for (const auto k : order) {
    if (runs[k].error >= least) continue;
    least = runs[k].error;
    front.push_back(k);
  }
  return front;
}

std::optional<CostOfError> cost_of_error(std::span<const Judged> line, double error) {
  std::optional<CostOfError> least;
  const auto take = [&](double cost, bool at_most) {
    if (!least || cost < least->cost) least = CostOfError{cost, at_most};
  };
  for (std::size_t k = 0; k < line.size(); ++k)
    if (line[k].error <= error) take(line[k].cost, true);
  for (std::size_t k = 0; k + 1 < line.size(); ++k) {
    const auto& [a, b] =
        std::minmax(line[k], line[k + 1], [](const auto& x, const auto& y) { return x.error < y.error; });
    if (a.error <= error && b.error > error) take(cost_between(b, a, error), false);
  }
  return least;
}

}  // namespace tektite
