#include "core/sparse/cholesky.h"
#include "solver.h"

namespace shapespline::bench {
namespace {

// The time includes copying the right-hand side, because the other solvers do not solve in place.
template <class Real>
Eigen::MatrixX3d solve(const Cholesky& cholesky, const Eigen::MatrixX3d& b, double& ms) {
  const auto position = cholesky.eliminationPosition();
  std::vector<Real, Eigen::aligned_allocator<Real>> start(4 * static_cast<std::size_t>(cholesky.paddedSize()), Real(0)),
      x;
  for (Eigen::Index i = 0; i < b.rows(); ++i)
    for (int k = 0; k < 3; ++k) start[4 * static_cast<std::size_t>(position[i]) + k] = static_cast<Real>(b(i, k));
  ms = medianMs([&] {
    x = start;
    cholesky.solve(x.data());
  });
  Eigen::MatrixX3d result(b.rows(), 3);
  for (Eigen::Index i = 0; i < b.rows(); ++i)
    for (int k = 0; k < 3; ++k) result(i, k) = x[4 * static_cast<std::size_t>(position[i]) + k];
  return result;
}

}  // namespace

std::optional<SolverRound> solveByOurs(const KnownSystem& system, Precision precision) {
  const CotangentLaplacian& laplacian = system.laplacian;
  SolverRound round;
  Cholesky cholesky;
  Stopwatch watch;
  if (!cholesky.analyse(laplacian.matrix, laplacian.coordinates, precision)) return {};
  round.orderMs = watch.lap();
  bool good = true;
  round.factorMs = medianMs([&] { good = good && cholesky.factorise(laplacian.matrix).ok(); });
  if (!good) return {};
  round.error = system.errorOf(precision == Precision::Single ? solve<float>(cholesky, system.b, round.solveMs)
                                                              : solve<double>(cholesky, system.b, round.solveMs));
  const CholeskyStats stats = cholesky.stats();
  round.entries = stats.factorEntries;
  round.bytes = stats.factorBytes + stats.indexBytes;
  return round;
}

}  // namespace shapespline::bench
