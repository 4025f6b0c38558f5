// Nearest neighbour among points, with a filter: the core's own because the filter ("in another component") prunes the
// search.
#pragma once

#include <algorithm>
#include <limits>
#include <numeric>
#include <vector>

#include "core/base/types.h"

namespace shapespline {

/// A static kd-tree over some of the given points, which must outlive it. Deterministic: equal distances go to the
/// lower index.
class KdTree {
 public:
  KdTree(const Positions& points, std::vector<int> subset) : points_(points), order_(std::move(subset)) {
    build(0, static_cast<int>(order_.size()), 0);
  }

  /// The point nearest `query` for which accept(index) holds, or -1.
  template <class Accept>
  int nearest(const Vec3& query, Accept accept) const {
    Best best;
    const auto skip = [](int) { return false; };
    search(query, accept, skip, 0, static_cast<int>(order_.size()), 0, best);
    return best.index;
  }

  int nearest(const Vec3& query) const {
    return nearest(query, [](int) { return true; });
  }

  /// For nearestOther: of each subtree the label that all its points share, or -1 where they differ. label(index) >= 0.
  template <class Label>
  std::vector<int> sharedLabels(Label label) const {
    std::vector<int> shared(order_.size());
    if (!shared.empty()) share(label, 0, static_cast<int>(order_.size()), shared);
    return shared;
  }

  /// The point nearest `query` with another label than `own`, at a squared distance below `within`; -1 where there is
  /// none. Subtrees without another label are passed over: the search does not wade through what is near and of the
  /// same label.
  template <class Label>
  int nearestOther(const Vec3& query, Label label, const std::vector<int>& shared, int own, double within) const {
    Best best{within, -1};
    const auto accept = [&](int point) { return label(point) != own; };
    const auto skip = [&](int middle) { return shared[middle] == own; };
    search(query, accept, skip, 0, static_cast<int>(order_.size()), 0, best);
    return best.index;
  }

  /// Visits the points with another label than `own` at a squared distance below `within`, in no order.
  template <class Label, class Visit>
  void eachOther(const Vec3& query, Label label, const std::vector<int>& shared, int own, double within,
                 Visit visit) const {
    Best best{within, -1};
    const auto accept = [&](int point) {
      if (label(point) != own) visit(point);
      return false;  // the bound stays
    };
    const auto skip = [&](int middle) { return shared[middle] == own; };
    search(query, accept, skip, 0, static_cast<int>(order_.size()), 0, best);
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

  // A subtree is known by the place of its root.
  template <class Label>
  int share(Label& label, int first, int last, std::vector<int>& shared) const {
    const int middle = (first + last) / 2;
    int common = label(order_[middle]);
    if (first < middle && share(label, first, middle, shared) != common) common = -1;
    if (middle + 1 < last && share(label, middle + 1, last, shared) != common) common = -1;
    return shared[middle] = common;
  }

  template <class Accept, class Skip>
  void search(const Vec3& query, const Accept& accept, const Skip& skip, int first, int last, int axis,
              Best& best) const {
    if (first >= last) return;
    const int middle = (first + last) / 2;
    if (skip(middle)) return;
    const int point = order_[middle];
    const double squared = (points_[point] - query).squaredNorm();
    if ((squared < best.squared || (squared == best.squared && point < best.index)) && accept(point))
      best = {squared, point};
    const double offset = query[axis] - points_[point][axis];
    const int next = (axis + 1) % 3;
    const bool below = offset < 0;
    search(query, accept, skip, below ? first : middle + 1, below ? middle : last, next, best);
    if (offset * offset <= best.squared)
      search(query, accept, skip, below ? middle + 1 : first, below ? last : middle, next, best);
  }

  const Positions& points_;
  std::vector<int> order_;
};

}  // namespace shapespline
