#include "boundary/touching_bodies.hpp"

#include <algorithm>
#include <limits>
#include <set>

#include "core/saved_number.hpp"
#include "parallel/ranks.hpp"

namespace tektite {
namespace {

/// Of the energy at the start: what the order of neighbours may change in a sum must not be taken for a push.
constexpr double of_rounding = 1e-9;

constexpr double infinite = std::numeric_limits<double>::infinity();
const std::string count_name = "contact_bodies_in_touch", pair_name = "contact_at_start_";

std::string name_of(std::uint32_t a, std::uint32_t b) {
  return pair_name + std::to_string(a) + "_" + std::to_string(b);
}

using BodyPairs = std::set<std::pair<std::uint32_t, std::uint32_t>>;

/// What any rank has.
BodyPairs joined(const BodyPairs& own) {
  Words words;
  for (const auto& [a, b] : own) words.insert(words.end(), {a, b});
  BodyPairs all;
  for (const auto& one : gather_on_all(words))
    for (std::size_t k = 0; k < one.size(); k += 2)
      all.insert({static_cast<std::uint32_t>(one[k]), static_cast<std::uint32_t>(one[k + 1])});
  return all;
}

/// Of every two bodies with particles near to each other, both ways.
BodyPairs near_in(const Particles& particles, const PairList& list, const std::vector<std::uint32_t>& body) {
  BodyPairs near;
  std::pair<std::uint32_t, std::uint32_t> last{0, 0};  // of most pairs of particles the same as of those before
  for (const auto& block : list.blocks())
    for (std::size_t k = 0; k + 1 < block.first.size(); ++k)
      for (auto n = block.first[k]; n < block.first[k + 1]; ++n) {
        const std::pair bodies{body[block.begin + k], body[block.neighbours[n]]};
        if (bodies.first == bodies.second || bodies == last) continue;
        near.insert(bodies);
        last = bodies;
      }
  return distributed(particles) ? joined(near) : near;
}

}  // namespace

void TouchingBodies::find(const Particles& particles, const PairList& list, const std::vector<std::uint32_t>& body,
                          const std::function<void(const PairList&, std::vector<ContactSum>&)>& sums_of) {
  at_start_.clear();
  for (const auto& bodies : near_in(particles, list, body)) at_start_[bodies] = infinite;
  sort(particles, list, body);
  const double* volume = particles.scalars(Field::reference_volume);
  const Owned owned(particles);
  const auto larger = [](double& whole, double part) { whole = std::max(whole, part); };
  std::map<Bodies, double> found;
  for (const auto& turn : turns_) {
    std::vector<ContactSum> sums(particles.count());
    sums_of(turn.pairs, sums);
    std::vector<double> most(particles.bodies().size(), 0.0);
    for (std::size_t i = 0; i < sums.size(); ++i)
      if (owned(i)) larger(most[body[i]], sums[i].energy / volume[i]);
    each_over_ranks(particles, most, larger);
    for (std::uint32_t a = 0; a < most.size(); ++a)
      if (most[a] > 0.0) found[Bodies(a, turn.other[a])] = most[a] * (1.0 + of_rounding);
  }
  at_start_ = std::move(found);
}

void TouchingBodies::sort(const Particles& particles, const PairList& list, const std::vector<std::uint32_t>& body) {
  turns_.clear();
  BodyPairs counted;
  for (const auto& [a, b] : near_in(particles, list, body))
    if (const double own = at_start(a, b), other = at_start(b, a); own > 0.0) {
      counted.insert({a, b});
      if (a < b) give_turn({a, b}, own, other, static_cast<std::uint32_t>(particles.bodies().size()));
    }
  apart_ = list;
  apart_.keep_pairs([&](auto i, auto j) { return !counted.contains({body[i], body[j]}); });
  apart_.drop_empty_runs();
  for (auto& turn : turns_) {
    turn.pairs = list;
    turn.pairs.keep_pairs([&](auto i, auto j) { return body[i] != body[j] && turn.other[body[i]] == body[j]; });
    turn.pairs.drop_empty_runs();
  }
}

double TouchingBodies::at_start(std::uint32_t a, std::uint32_t b) const {
  const auto found = at_start_.find({a, b});
  return std::max(found == at_start_.end() ? 0.0 : found->second, at_faces_(a, b));
}

/// The first turn in which neither has another one yet.
void TouchingBodies::give_turn(const Bodies& bodies, double own, double other, std::uint32_t count) {
  const auto [a, b] = bodies;
  std::size_t t = 0;
  while (t < turns_.size() && (turns_[t].other[a] != a || turns_[t].other[b] != b)) ++t;
  if (t == turns_.size()) {
    turns_.push_back({{}, std::vector<std::uint32_t>(count), std::vector<double>(count, infinite)});
    for (std::uint32_t k = 0; k < count; ++k) turns_[t].other[k] = k;
  }
  turns_[t].other[a] = b;
  turns_[t].other[b] = a;
  turns_[t].at_start[a] = own;
  turns_[t].at_start[b] = other;
}

bool TouchingBodies::any_in(const std::map<std::string, double>& state) {
  const auto count = state.find(count_name);
  return count == state.end() || count->second > 0.0;
}

void TouchingBodies::save(std::map<std::string, double>& state) const {
  state[count_name] = static_cast<double>(at_start_.size());
  for (const auto& [bodies, energy] : at_start_) state[name_of(bodies.first, bodies.second)] = energy;
}

void TouchingBodies::restore(const std::map<std::string, double>& state, std::uint32_t bodies) {
  at_start_.clear();
  const double count = saved_number(state, count_name);
  for (std::uint32_t a = 0; count > 0.0 && a < bodies; ++a)
    for (std::uint32_t b = 0; b < bodies; ++b)
      if (const auto found = state.find(name_of(a, b)); found != state.end()) at_start_[{a, b}] = found->second;
  if (static_cast<double>(at_start_.size()) != count) throw MissingNumber(pair_name + "BODY_BODY");
}

std::size_t TouchingBodies::memory() const {
  std::size_t bytes = apart_.memory();
  for (const auto& turn : turns_) bytes += turn.pairs.memory();
  return bytes;
}

}  // namespace tektite
