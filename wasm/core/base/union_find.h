// Disjoint sets.
#pragma once

#include <algorithm>
#include <numeric>
#include <vector>

namespace shapespline {

/// Disjoint sets of the numbers below n (Tarjan 1975, with path halving). A set's representative is its smallest
/// member, independent of the order of joins.
class UnionFind {
 public:
  UnionFind() = default;
  /// Initially, every number is its own set.
  explicit UnionFind(int n) { reset(n); }

  /// Resets it, reusing its memory.
  void reset(int n) {
    parent_.resize(n);
    std::iota(parent_.begin(), parent_.end(), 0);
  }

  /// Smallest member of the set that contains x.
  int find(int x) {
    while (parent_[x] != x) x = parent_[x] = parent_[parent_[x]];
    return x;
  }

  /// Returns false if a and b are already in one set.
  bool join(int a, int b) {
    a = find(a);
    b = find(b);
    if (a == b) return false;
    parent_[std::max(a, b)] = std::min(a, b);
    return true;
  }

 private:
  std::vector<int> parent_;
};

}  // namespace shapespline
