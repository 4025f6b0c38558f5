// The linear systems of the fits: J^T W J of lengths and angles, in 3 x 3 blocks of vertices, damped and factored.
#pragma once

#include <vector>

#include "core/base/status.h"
#include "core/sparse/cholesky.h"
#include "shells/shell_metric.h"

namespace shapespline {

/// The sparsity pattern is the same for all shapes of a mesh, so it is analysed once. Each shape fills and factors it.
class ShellSystem {
 public:
  /// metric: must outlive this object. Errors: those of the solver.
  static Result<ShellSystem> create(const ShellMetric& metric);

  const ShellMetric& metric() const { return *metric_; }

  /// Computes J^T W J of a shape.
  void fill(const Positions& positions);

  /// Factors the filled matrix, after adding `damping` times the mean diagonal of each vertex to its diagonal. This is
  /// one number per vertex, so a rotation of all shapes changes nothing. Returns false if the matrix is not positive
  /// definite.
  bool factor(double damping);

  /// Solves with the last factor.
  Positions solve(const Positions& right);

  /// J^T W d of a shape.
  Positions transposed(const Positions& positions, const ShellMeasures& difference) const;

  int factorCount() const { return factors_; }

 private:
  // A block of the lower triangle, with the starts of its three columns.
  struct Block {
    int lower, higher;  // vertices
    std::array<int, 3> start;
  };
  using Work = std::vector<double, Eigen::aligned_allocator<double>>;

  explicit ShellSystem(const ShellMetric& metric) : metric_(&metric) {}
  void findPattern();
  void add(const Block& block, const Mat3& part);
  int blockOf(int a, int b) const;

  const ShellMetric* metric_;
  SymmetricMatrix matrix_, damped_;
  std::vector<int> rowStart_;  // index in blocks_ of each vertex's first block, which is its diagonal block
  std::vector<Block> blocks_;
  std::vector<std::array<int, 10>> blocksOf_;  // blocks to which each measure adds
  Cholesky solver_;
  Work work_;
  int factors_ = 0;
};

/// to += factor * from.
void addScaled(Positions& to, double factor, const Positions& from);
double dot(const Positions& a, const Positions& b);
double largestNorm(const Positions& p);

}  // namespace shapespline
