// Where parts of a shape are nearest to each other, in all its poses at once.
#pragma once

#include <limits>
#include <span>
#include <vector>

#include "core/base/types.h"
#include "core/mesh/kd_tree.h"

namespace shapespline {

/// Two vertices, and the square of the largest of their distances over the poses.
struct Contact {
  double distance = std::numeric_limits<double>::infinity();
  int from = -1, to = -1;
};

/// Finds contacts with some of the vertices. The poses must outlive it.
class ContactSearch {
 public:
  ContactSearch(std::span<const Positions* const> poses, const std::vector<int>& vertices);

  /// Of the vertices nearest to `from` in some poses, among those for which accept(vertex) holds, the one of least
  /// distance; `to` is -1 where there is none.
  template <class Accept>
  Contact nearest(int from, Accept accept) const {
    Contact best;
    for (std::size_t k = 0; k < trees_.size(); ++k) {
      const int to = trees_[k].nearest((*searched_[k])[from], accept);
      if (to < 0) continue;
      if (const double d = distance(from, to); d < best.distance) best = {d, from, to};
    }
    return best;
  }

  /// Of each tree's subtrees the label that all of their vertices share (kd_tree.h), for nearestOther.
  template <class Label>
  std::vector<std::vector<int>> sharedLabels(Label label) const {
    std::vector<std::vector<int>> shared;
    for (const KdTree& tree : trees_) shared.push_back(tree.sharedLabels(label));
    return shared;
  }

  /// Puts a contact of `from` with a vertex of another label into `best` where it is nearer. The distance is the
  /// largest of all poses: what is no nearer in one of them is passed over.
  template <class Label>
  void nearestOther(int from, Label label, const std::vector<std::vector<int>>& shared, Contact& best) const {
    for (std::size_t k = 0; k < trees_.size(); ++k) {
      const int to = trees_[k].nearestOther((*searched_[k])[from], label, shared[k], label(from), best.distance);
      if (to < 0) continue;
      if (const double d = distance(from, to); d < best.distance) best = {d, from, to};
    }
  }

  /// Of the vertices of another label that are nearer to `from` than `within` (a square) in all poses the lowest; -1
  /// without any.
  template <class Label>
  int lowestOther(int from, Label label, const std::vector<std::vector<int>>& shared, double within) const {
    int lowest = -1;
    const auto visit = [&](int to) {
      if ((lowest < 0 || to < lowest) && distance(from, to) < within) lowest = to;
    };
    trees_[0].eachOther((*searched_[0])[from], label, shared[0], label(from), within, visit);
    return lowest;
  }

 private:
  double distance(int a, int b) const;

  std::span<const Positions* const> poses_;
  std::vector<const Positions*> searched_;
  std::vector<KdTree> trees_;
};

/// At most `limit` of the items, evenly spread.
std::vector<int> spreadSample(const std::vector<int>& items, int limit);

}  // namespace shapespline
