// The linear systems of lengths and angles: J^T W J in 3 x 3 blocks of vertices, damped and factored.
#pragma once

#include <vector>

#include "core/base/status.h"
#include "core/sparse/cholesky.h"
#include "shells/shell_metric.h"

namespace shapespline {

/// One pattern for all shapes of a mesh: analysed once, filled and factored again and again.
class ShellSystem {
 public:
  /// metric: must outlive it. Errors: those of the solver.
  static Result<ShellSystem> create(const ShellMetric& metric);

  const ShellMetric& metric() const { return *metric_; }

  /// J^T W J of a shape.
  void fill(const Positions& positions);

  /// Factors what was filled, plus on each vertex `damping` times the mean of its diagonal: one number per vertex, so
  /// rotating all shapes changes nothing. False where it is not positive definite.
  bool factor(double damping);

  /// Solves with the last factor.
  Positions solve(const Positions& right);

  /// J^T W d of a shape.
  Positions transposed(const Positions& positions, const ShellMeasures& difference) const;

  int factorCount() const { return factors_; }

 private:
  // Where the three columns of a block of the lower triangle start.
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
  std::vector<int> rowStart_;  // of each vertex, in blocks_: its diagonal block first
  std::vector<Block> blocks_;
  std::vector<std::array<int, 10>> blocksOf_;  // of each measure
  Cholesky solver_;
  Work work_;
  int factors_ = 0;
};

/// The vertices times a number, added to others.
void addScaled(Positions& to, double factor, const Positions& from);
double dot(const Positions& a, const Positions& b);
double largestNorm(const Positions& p);

}  // namespace shapespline
