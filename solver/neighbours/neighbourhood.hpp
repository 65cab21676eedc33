#pragma once
// Keeps the particles ordered in space and the list of pairs valid: it is made anew when two particles that were not
// near may have come near. That is judged region by region, so that fast fragments do not count where they are not.
// List and images follow from the order of the particles, the search positions and the reach alone, all of which are
// saved, so a restart goes on with the same list.

#include <map>
#include <string>
#include <vector>

#include "boundary/mirror.hpp"
#include "core/particles.hpp"
#include "neighbours/cell_grid.hpp"
#include "neighbours/pair_list.hpp"
#include "parallel/halo.hpp"
#include "passes/vector_box.hpp"

namespace tektite {

/// Whose neighbours are listed: of particles with Eulerian kernels, or also of all that are near to one.
enum class Listed { all, eulerian, eulerian_and_near };

/// What a neighbourhood is for.
struct Search {
  Pairing pairing = Pairing::all;
  bool orders = true;                        ///< keeps the particles ordered in space
  Field positions = Field::search_position;  ///< where it keeps the places of the last search
  Listed listed = Listed::all;               ///< whose neighbours it lists
  bool apart = false;                        ///< of one body, only pairs that are no neighbours in any sum (list())
  std::string name = "search";               ///< under which it is saved
};

template <int D>
class Neighbourhood {
 public:
  /// `support` is the farthest distance in m at which two particles act on each other.
  Neighbourhood(Particles& particles, double support, std::vector<SymmetryPlane> planes, Search search = {});

  /// Makes the list good for the positions in the middle of a step dt. True where the particles were ordered anew.
  /// Where they are distributed, that is due before, because the other ranks' particles have to be fetched in between.
  bool prepare(double dt);
  /// Makes the list anew, whatever has moved. True where the particles were ordered anew.
  bool renew(double dt);
  /// Whether the list is not good for the middle of a step dt.
  bool due(double dt);
  /// renew() up to the list: order, places and reach. True where the particles were ordered anew.
  bool begin(double dt);
  /// What so many sweeps one behind the other reach, with the list that `state` has or with the first one.
  Halo halo(const std::map<std::string, double>& state, int sweeps) const;
  /// Lists again from the places of the last search, after particles have got another kind of kernel.
  void list();
  /// Puts what belongs to the present list, beside the particles, into `state`; restore() makes the same list from
  /// both.
  void save(std::map<std::string, double>& state) const;
  void restore(const std::map<std::string, double>& state);

  const PairList& pairs() const { return pairs_; }
  /// How many lists there have been: who keeps something that follows from one sees by it that there is another.
  std::size_t lists() const { return lists_; }
  /// Whose records a loop over the pairs reads, in ascending order; kept where the list is not of all particles.
  const std::vector<std::uint32_t>& members() const { return members_; }
  const Mirror<D>& mirror() const { return mirror_; }
  double reach() const { return reach_; }
  double support() const { return support_; }
  std::size_t memory() const;

 private:
  /// By how much two particles may have come nearer since the last search, at the middle of a step dt.
  struct Approach {
    double near;  ///< those of the same or of touching regions, m
    double far;   ///< any two, m
  };
  Approach approach(double dt);
  void find_regions();
  void keep_apart(const std::vector<std::uint32_t>& body);
  void find_members();

  Particles& particles_;
  double support_;
  Search search_;
  double reach_ = 0.0;
  int searches_since_order_ = 0;
  Mirror<D> mirror_;
  CellGrid<D> regions_;
  std::vector<std::uint32_t> occupied_;  ///< regions that have particles here
  std::vector<VectorBox<D>> boxes_;      ///< of the displacements since the last search, region by region
  PairList pairs_;
  std::size_t lists_ = 0;
  std::vector<std::uint32_t> members_;
  std::vector<Vector<double, D>> places_;
};

}  // namespace tektite
