// Solves the second system with several solvers, and measures times, memory and accuracy.
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

/// A system with a known solution: the positions of the vertices.
struct KnownSystem {
  explicit KnownSystem(const CotangentLaplacian& laplacian);

  /// Largest distance of a solution from the positions, relative to the diagonal of their bounding box.
  double errorOf(const Eigen::MatrixX3d& solution) const;

  const CotangentLaplacian& laplacian;
  Eigen::SparseMatrix<double> matrix;  ///< lower triangle
  Eigen::MatrixX3d positions, b;
};

/// Times in ms: one analysis (order and structure); medians of a few factorisations and solves of three columns.
struct SolverRound {
  double orderMs = 0, factorMs = 0, solveMs = 0;
  std::int64_t entries = 0;  ///< entries of the triangular factor
  std::int64_t bytes = 0;    ///< bytes of the stored factor, with its indices
  double error = 0;          ///< KnownSystem::errorOf
};

/// Returns nullopt if the system cannot be factored.
std::optional<SolverRound> solveByOurs(const KnownSystem& system, Precision precision);
std::optional<SolverRound> solveByEigen(const KnownSystem& system);
/// Also returns nullopt if CHOLMOD was not installed at compile time.
std::optional<SolverRound> solveByCholmod(const KnownSystem& system);

/// The median of up to five runs that start within three seconds.
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
