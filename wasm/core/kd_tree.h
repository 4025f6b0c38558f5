// Nearest neighbour among points, with a filter: the core's own because the filter ("in another piece") prunes the search.
#pragma once

#include <algorithm>
#include <limits>
#include <numeric>
#include <vector>

#include "core/types.h"

namespace shapespline {

/// A static kd-tree over some of the given points, which must outlive it. Deterministic: equal distances go to the lower
/// index.
class KdTree {
 public:
  KdTree(const Positions& points, std::vector<int> subset) : points_(points), order_(std::move(subset)) {
    build(0, static_cast<int>(order_.size()), 0);
  }

  /// The point nearest `query` for which accept(index) holds, or -1.
  template <class Accept>
  int nearest(const Vec3& query, Accept accept) const {
    Best best;
    search(query, accept, 0, static_cast<int>(order_.size()), 0, best);
    return best.index;
  }

  int nearest(const Vec3& query) const {
    return nearest(query, [](int) { return true; });
  }

 private:
  struct Best {
    double squared = std::numeric_limits<double>::infinity();
    int index = -1;
  };

  // The median of each range splits it along the axes in turn; a range is its own subtree.
  void build(int first, int last, int axis) {
    if (last - first < 2) return;
    const int middle = (first + last) / 2;
    std::nth_element(order_.begin() + first, order_.begin() + middle, order_.begin() + last, [&](int a, int b) {
      const double x = points_[a][axis], y = points_[b][axis];
      return x != y ? x < y : a < b;
    });
    build(first, middle, (axis + 1) % 3);
    build(middle + 1, last, (axis + 1) % 3);
  }

  template <class Accept>
  void search(const Vec3& query, Accept& accept, int first, int last, int axis, Best& best) const {
    if (first >= last) return;
    const int middle = (first + last) / 2;
    const int point = order_[middle];
    const double squared = (points_[point] - query).squaredNorm();
    if ((squared < best.squared || (squared == best.squared && point < best.index)) && accept(point))
      best = {squared, point};
    const double offset = query[axis] - points_[point][axis];
    const int next = (axis + 1) % 3;
    const bool below = offset < 0;
    search(query, accept, below ? first : middle + 1, below ? middle : last, next, best);
    if (offset * offset <= best.squared)
      search(query, accept, below ? middle + 1 : first, below ? last : middle, next, best);
  }

  const Positions& points_;
  std::vector<int> order_;
};

}  // namespace shapespline
