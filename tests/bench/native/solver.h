// The second system by several solvers: times, memory, accuracy.
#pragma once

#include <algorithm>
#include <cstdint>
#include <optional>
#include <vector>

#include <Eigen/SparseCore>

#include "core/base/precision.h"
#include "core/base/stopwatch.h"
#include "core/reconstruct/poisson.h"

namespace shapespline::bench {

/// A system whose solution is known: the vertices' positions.
struct KnownSystem {
  explicit KnownSystem(const CotangentLaplacian& laplacian);

  /// Largest distance of a solution to the positions, over the diagonal of their bounding box.
  double errorOf(const Eigen::MatrixX3d& solution) const;

  const CotangentLaplacian& laplacian;
  Eigen::SparseMatrix<double> matrix;  ///< lower triangle
  Eigen::MatrixX3d positions, b;
};

/// The order and the structure once; the factorisation and a solve of three columns as medians of a few.
struct SolverRound {
  double orderMs = 0, factorMs = 0, solveMs = 0;
  std::int64_t entries = 0;  ///< of the triangular factor
  std::int64_t bytes = 0;    ///< of the factor as it is stored, indices included
  double error = 0;          ///< KnownSystem::errorOf
};

/// Nothing where the system cannot be factored.
std::optional<SolverRound> solveByOurs(const KnownSystem& system, Precision precision);
std::optional<SolverRound> solveByEigen(const KnownSystem& system);
/// Nothing, too, where CHOLMOD was not installed when this was compiled.
std::optional<SolverRound> solveByCholmod(const KnownSystem& system);

/// The median of up to five runs, begun within three seconds.
template <class Work>
double medianMs(Work work) {
  std::vector<double> ms;
  double sum = 0;
  while (ms.size() < 5 && sum < 3000) {
    Stopwatch watch;
    work();
    ms.push_back(watch.lap());
    sum += ms.back();
  }
  std::sort(ms.begin(), ms.end());
  return ms[ms.size() / 2];
}

}  // namespace shapespline::bench
