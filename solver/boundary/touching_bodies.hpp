#pragma once
// The bodies that touch at the start: what a particle of one has of the contact with another then, and whose pairs are
// summed together. Where the scene says so, all bodies push each other only from where their faces touch. A particle's
// sums are taken for each other body by itself, so pairs of bodies take turns, in each of which a body has at most one
// other.

#include <cstdint>
#include <functional>
#include <map>
#include <string>
#include <utility>
#include <vector>

#include "core/particles.hpp"
#include "neighbours/pair_list.hpp"
#include "passes/touching_contact.hpp"

namespace tektite {

class TouchingBodies {
 public:
  struct Turn {
    PairList pairs;
    std::vector<std::uint32_t> other;  ///< of each body; itself where it has none
    std::vector<double> at_start;      ///< E*/V of each body's particles, J/m³; infinite where it has no other
  };

  /// `at_faces(a, b)` is what a particle in the face of the body a has of the contact with b where their faces touch,
  /// J/m³; zero where bodies that start apart push each other from where their kernels meet.
  explicit TouchingBodies(std::function<double(std::uint32_t, std::uint32_t)> at_faces)
      : at_faces_(std::move(at_faces)) {}

  /// Finds them: `list` holds all pairs near to each other, `body` says whose each particle and image is, and
  /// sums_of(list, sums) sums the potential up over a list.
  void find(const Particles& particles, const PairList& list, const std::vector<std::uint32_t>& body,
            const std::function<void(const PairList&, std::vector<ContactSum>&)>& sums_of);

  /// Shares the pairs of a new list out.
  void sort(const Particles& particles, const PairList& list, const std::vector<std::uint32_t>& body);

  const std::vector<Turn>& turns() const { return turns_; }
  /// The pairs that push each other from where their kernels meet.
  const PairList& apart() const { return apart_; }

  /// Whether there may be some: none only where save() has put that into `state`.
  static bool any_in(const std::map<std::string, double>& state);
  void save(std::map<std::string, double>& state) const;
  void restore(const std::map<std::string, double>& state, std::uint32_t bodies);
  std::size_t memory() const;

 private:
  using Bodies = std::pair<std::uint32_t, std::uint32_t>;
  double at_start(std::uint32_t a, std::uint32_t b) const;
  void give_turn(const Bodies& bodies, double own, double other, std::uint32_t count);

  std::function<double(std::uint32_t, std::uint32_t)> at_faces_;
  std::map<Bodies, double> at_start_;  ///< of those that touch, J/m³
  std::vector<Turn> turns_;
  PairList apart_;
};

}  // namespace tektite
