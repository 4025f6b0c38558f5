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

/// One running factorisation. Update matrices lie on two stacks that grow towards each other, a front's on the one and
/// its children's on the other: each is made where it stays. Between them are the columns of the current front.
class Multifrontal {
 public:
  /// The structure must outlive this. values: the matrix's, which are copied in the order in which fronts take them.
  Multifrontal(const SymbolicFactor& symbolic, const Assembly& assembly, std::span<const double> values);

  int supernode() const { return supernode_; }
  bool done() const { return supernode_ == symbolic_.supernodes(); }

  /// Works on the current supernode for about flopBudget operations, which it reduces by what it took. True when the
  /// front is eliminated: read it with columns(), then call finishFront() to go on.
  bool eliminate(double& flopBudget);
  const double* columns() const { return stack_.get() + low_; }
  const double* inverse() const { return inverse_.data(); }  // of its diagonal tiles
  void finishFront();

  int regularisedPivots() const { return regularised_; }
  /// Position of the first pivot that was negative or not finite, or -1.
  int failedPosition() const { return failed_; }
  double flopsDone() const { return flopsDone_; }
  std::size_t stackDoubles() const { return stackSize_; }

 private:
  void assembleFront();
  enum class Part { Columns, Update };
  void addChildren(Part part);

  const SymbolicFactor& symbolic_;
  const Assembly& assembly_;
  std::unique_ptr<double[]> values_;  // by their slots
  std::size_t stackSize_;             // doubles
  std::unique_ptr<double[]> stack_;
  std::vector<int> firstChild_, sibling_;  // last pushed child first
  std::vector<char> isHigh_;               // supernodes whose update matrix goes to the high stack
  std::vector<std::size_t> updateBase_;    // of each supernode whose update matrix is on a stack
  std::vector<double> reference_, inverse_;
  std::size_t low_ = 0, high_;  // where the low stack ends and the high one begins
  int supernode_ = 0;
  int nextStrip_ = -1;  // of the current front, -1 before it is assembled
  int regularised_ = 0;
  int failed_ = -1;
  double flopsDone_ = 0.0;
};

/// Operations of the whole factorisation, as flopsDone() counts them.
double factorisationFlops(const SymbolicFactor& symbolic);

}  // namespace shapespline
