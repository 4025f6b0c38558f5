// The undirected graph of a sparse symmetric matrix, the input of ordering algorithms.
#pragma once

#include <span>
#include <vector>

#include "core/sparse/sparse_matrix.h"

namespace shapespline {

/// Adjacency lists without loops; every edge is listed at both ends. Node v's neighbours are
/// neighbour[start[v]] ... neighbour[start[v + 1] - 1], ascending.
struct Graph {
  std::vector<int> start = {0};
  std::vector<int> neighbour;

  int size() const { return static_cast<int>(start.size()) - 1; }
  int degree(int v) const { return start[v + 1] - start[v]; }
  std::span<const int> neighbours(int v) const {
    return {neighbour.data() + start[v], neighbour.data() + start[v + 1]};
  }
};

/// The graph with an edge for every stored off-diagonal entry, including stored zeros.
Graph graphOf(const SymmetricMatrix& matrix);

}  // namespace shapespline
