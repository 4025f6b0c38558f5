#include <Eigen/SparseCholesky>

#include "solver.h"

namespace shapespline::bench {

std::optional<SolverRound> solveByEigen(const KnownSystem& system) {
  Eigen::SimplicialLLT<Eigen::SparseMatrix<double>> eigen;
  SolverRound round;
  Stopwatch watch;
  eigen.analyzePattern(system.matrix);
  round.orderMs = watch.lap();
  round.factorMs = medianMs([&] { eigen.factorize(system.matrix); });
  if (eigen.info() != Eigen::Success) return {};
  Eigen::MatrixX3d x;
  round.solveMs = medianMs([&] { x = eigen.solve(system.b); });
  round.entries = eigen.matrixL().nestedExpression().nonZeros();
  round.bytes = round.entries * static_cast<std::int64_t>(sizeof(double) + sizeof(int));
  round.error = system.errorOf(x);
  return round;
}

}  // namespace shapespline::bench
