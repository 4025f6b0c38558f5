// Disjoint sets.
#pragma once

#include <algorithm>
#include <numeric>
#include <vector>

namespace shapespline {

/// Sets of the numbers below n, joined one by one (Tarjan 1975, paths halved). A set's least member stands for it, in
/// whichever order sets are joined.
class UnionFind {
 public:
  UnionFind() = default;
  /// Every number is a set of its own.
  explicit UnionFind(int n) { reset(n); }

  /// Resets it, reusing its memory.
  void reset(int n) {
    parent_.resize(n);
    std::iota(parent_.begin(), parent_.end(), 0);
  }

  /// The least member of the set that x is in.
  int find(int x) {
    while (parent_[x] != x) x = parent_[x] = parent_[parent_[x]];
    return x;
  }

  /// Returns false where a and b are in one set already.
  bool join(int a, int b) {
    a = find(a), b = find(b);
    if (a == b) return false;
    parent_[std::max(a, b)] = std::min(a, b);
    return true;
  }

 private:
  std::vector<int> parent_;
};

}  // namespace shapespline
