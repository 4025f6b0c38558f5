// Multifrontal Cholesky factorisation (Duff and Reid 1983; Liu 1992) in double precision, supernode by supernode.
#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <span>
#include <vector>

#include "core/sparse/front_assembly.h"
#include "core/sparse/symbolic.h"

namespace shapespline {

/// A running factorisation. Two stacks of update matrices grow towards each other: a front's matrix on one stack, its
/// children's on the other. Each matrix is computed at its final position. The columns of the current front lie between
/// the stacks.
class Multifrontal {
 public:
  /// The structure must outlive this. values: the matrix's values, copied in the order of the fronts.
  Multifrontal(const SymbolicFactor& symbolic, const Assembly& assembly, std::span<const double> values);

  int supernode() const { return supernode_; }
  bool done() const { return supernode_ == symbolic_.supernodes(); }

  /// Works on the current supernode for about flopBudget operations and subtracts the used ones. Returns true when the
  /// front is eliminated: read it with columns(), then call finishFront().
  bool eliminate(double& flopBudget);
  const double* columns() const { return stack_.get() + low_; }
  const double* inverse() const { return inverse_.data(); }  // inverses of the diagonal tiles
  void finishFront();

  int regularisedPivots() const { return regularised_; }
  /// Position of the first pivot that is negative or not finite, or -1.
  int failedPosition() const { return failed_; }
  double flopsDone() const { return flopsDone_; }
  std::size_t stackDoubles() const { return stackSize_; }

 private:
  void assembleFront();
  enum class Part { Columns, Update };
  void addChildren(Part part);

  const SymbolicFactor& symbolic_;
  const Assembly& assembly_;
  std::unique_ptr<double[]> values_;  // sorted by slot
  std::size_t stackSize_;             // in doubles
  std::unique_ptr<double[]> stack_;
  std::vector<int> firstChild_, sibling_;  // children in reverse order
  std::vector<char> isHigh_;               // supernodes whose update matrix is on the high stack
  std::vector<std::size_t> updateBase_;    // position of each stacked update matrix
  std::vector<double> reference_, inverse_;
  std::size_t low_ = 0, high_;  // end of the low stack and start of the high stack
  int supernode_ = 0;
  int nextStrip_ = -1;  // next strip of the current front, -1 before assembly
  int regularised_ = 0;
  int failed_ = -1;
  double flopsDone_ = 0.0;
};

/// Operations of the whole factorisation, counted like flopsDone().
double factorisationFlops(const SymbolicFactor& symbolic);

}  // namespace shapespline
