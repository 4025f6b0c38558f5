// Double accuracy with a factor in single precision.
#pragma once

#include <vector>

#include <Eigen/Core>

#include "core/sparse/cholesky.h"

namespace shapespline {

/// Iterative refinement (Wilkinson 1963): residuals in double, corrections in single. Immutable.
class IterativeRefinement {
 public:
  struct Scratch {
    std::vector<double> residual;
    std::vector<float, Eigen::aligned_allocator<float>> correction;
  };

  /// matrix: the matrix that the solver has factored in single precision.
  IterativeRefinement(const SymmetricMatrix& matrix, const Cholesky& solver);

  /// Solves A x = b from the given x until a correction is small relative to `extent`. b and x: (x, y, z, pad) of every
  /// unknown in elimination order, 4 * solver.paddedSize() numbers each. The pads of b must be zero; the pads of x are
  /// kept.
  void solve(const Cholesky& solver, const double* b, double* x, double extent, Scratch& scratch,
             ForkJoin* forkJoin = nullptr) const;

 private:
  void subtractProduct(const double* x, double* residual) const;

  SymmetricMatrix matrix_;  // in elimination order
};

}  // namespace shapespline
