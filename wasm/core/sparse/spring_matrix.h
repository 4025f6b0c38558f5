// A sum of springs between vertices, such as the cotangent matrix of a surface.
#pragma once

#include <algorithm>
#include <span>
#include <vector>

#include "core/sparse/sparse_matrix.h"

namespace shapespline {

/// The symmetric matrix K for which x'Kx is the sum of weight (x_i - x_j)^2 over the springs.
struct SpringMatrix {
  explicit SpringMatrix(int size) : diagonal(size, 0.0) {}

  void add(int i, int j, double weight) {
    if (i == j) return;
    diagonal[i] += weight;
    diagonal[j] += weight;
    belowDiagonal.push_back({std::max(i, j), std::min(i, j), -weight});
  }

  /// K + diag(extra). extra: one per vertex.
  SymmetricMatrix plus(std::span<const double> extra) && {
    const int size = static_cast<int>(diagonal.size());
    for (int v = 0; v < size; ++v) belowDiagonal.push_back({v, v, diagonal[v] + extra[v]});
    return assembleSymmetric(size, belowDiagonal);
  }

  std::vector<double> diagonal;
  std::vector<Triplet> belowDiagonal;
};

}  // namespace shapespline
