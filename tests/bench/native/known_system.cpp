#include "solver.h"

namespace shapespline::bench {
namespace {

Eigen::SparseMatrix<double> lowerTriangle(const SymmetricMatrix& matrix) {
  using Map = Eigen::Map<const Eigen::SparseMatrix<double>>;
  return Map(matrix.size, matrix.size, static_cast<Eigen::Index>(matrix.row.size()), matrix.columnStart.data(),
             matrix.row.data(), matrix.value.data());
}

}  // namespace

KnownSystem::KnownSystem(const CotangentLaplacian& laplacian)
    : laplacian(laplacian), matrix(lowerTriangle(laplacian.matrix)), positions(laplacian.matrix.size, 3) {
  for (Eigen::Index i = 0; i < positions.rows(); ++i) positions.row(i) = laplacian.coordinates[i];
  b = matrix.selfadjointView<Eigen::Lower>() * positions;
}

double KnownSystem::errorOf(const Eigen::MatrixX3d& solution) const {
  const double diagonal = (positions.colwise().maxCoeff() - positions.colwise().minCoeff()).norm();
  return (solution - positions).rowwise().norm().maxCoeff() / diagonal;
}

}  // namespace shapespline::bench
