#include "preprocess/dealing.hpp"

#include <algorithm>
#include <bit>
#include <limits>
#include <span>

#include "parallel/ranks.hpp"

namespace tektite::preprocess {
namespace {

constexpr std::size_t words_of_point = 3;

void append(const Point& point, Words& words) {
  for (const double x : point.c) words.push_back(std::bit_cast<Word>(x));
}

Point point_at(const Words& words, std::size_t at) {
  Point point;
  for (int k = 0; k < 3; ++k) point[k] = std::bit_cast<double>(words[at + static_cast<std::size_t>(k)]);
  return point;
}

std::vector<Words> for_each_rank() { return std::vector<Words>(static_cast<std::size_t>(ranks())); }

/// Sends these to the ranks, and gives what they have sent, rank by rank.
std::vector<Point> exchanged(std::vector<Words> to) {
  auto from = exchange_words(to);
  to = std::vector<Words>();  // which {} would leave as large as it is
  std::size_t count = 0;
  for (const auto& words : from) count += words.size() / words_of_point;
  std::vector<Point> points;
  points.reserve(count);
  for (auto& words : from) {
    for (std::size_t at = 0; at < words.size(); at += words_of_point) points.push_back(point_at(words, at));
    words = Words();
  }
  return points;
}

Box box_about(const std::vector<Point>& points) {
  constexpr double infinity = std::numeric_limits<double>::infinity();
  Box box{{{infinity, infinity, infinity}}, {{-infinity, -infinity, -infinity}}};
  for (const auto& p : points)
    for (int k = 0; k < 3; ++k) {
      box.lower[k] = std::min(box.lower[k], p[k]);
      box.upper[k] = std::max(box.upper[k], p[k]);
    }
  return box;
}

bool within(const Point& p, const Box& box, double margin) {
  for (int k = 0; k < 3; ++k)
    if (!(p[k] >= box.lower[k] - margin && p[k] <= box.upper[k] + margin)) return false;
  return true;
}

}  // namespace

Share this_share() { return {static_cast<std::size_t>(rank()), static_cast<std::size_t>(ranks())}; }

DealtPoints deal(std::vector<Point> own) {
  if (ranks() == 1) {
    const auto count = own.size();
    return {std::move(own), 0, count};
  }
  std::size_t before = 0, all = 0;
  const auto counts = gather_on_all({own.size()});
  for (std::size_t r = 0; r < counts.size(); ++r) {
    if (r < static_cast<std::size_t>(rank())) before += counts[r].front();
    all += counts[r].front();
  }
  auto to = for_each_rank();
  const auto place = [&](std::size_t n) { return std::clamp(n, before, before + own.size()) - before; };
  for (std::size_t r = 0; r < to.size(); ++r) {
    const auto range = Share{r, to.size()}.of(all);
    to[r].reserve((place(range.end) - place(range.begin)) * words_of_point);
    for (auto k = place(range.begin); k < place(range.end); ++k) append(own[k], to[r]);
  }
  own = std::vector<Point>();
  const auto first = this_share().of(all).begin;
  return {exchanged(std::move(to)), first, all};
}

std::vector<Point> points_about(const std::vector<Point>& own, double margin, const std::vector<Point>& points) {
  if (ranks() == 1) return points;
  const auto box = box_about(own);
  Words corners;
  append(box.lower, corners);
  append(box.upper, corners);
  const auto boxes = gather_on_all(corners);
  auto to = for_each_rank();
  for (std::size_t r = 0; r < to.size(); ++r) {
    const Box there{point_at(boxes[r], 0), point_at(boxes[r], words_of_point)};
    for (const auto& p : points)
      if (within(p, there, margin)) append(p, to[r]);
  }
  return exchanged(std::move(to));
}

std::size_t on_all_ranks(std::size_t own) {
  return of_all_ranks(own, [](std::size_t& whole, std::size_t part) { whole += part; });
}

}  // namespace tektite::preprocess
