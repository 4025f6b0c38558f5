// Multifrontal Cholesky factorisation (Duff and Reid 1983; Liu 1992) in double precision, supernode by supernode.
#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <vector>

#include "core/sparse_matrix.h"
#include "core/symbolic.h"

namespace shapespline {

/// Where the entries of a matrix go: those that column p of the factor starts from are entry i in
/// [start[p], start[p + 1]): matrix.value[source[i]] at row position row[i] >= p.
struct EntryMap {
  std::vector<int> start, row, source;
};

EntryMap mapEntries(const SymmetricMatrix& matrix, const std::vector<int>& position);

/// One running factorisation. Fronts and update matrices share one stack; a finished front is handed out before its
/// update matrix replaces those of its children.
class Multifrontal {
 public:
  /// All must outlive this. values: the matrix's.
  Multifrontal(const SymbolicFactor& symbolic, const EntryMap& map, const std::vector<double>& values);

  int supernode() const { return supernode_; }
  bool done() const { return supernode_ == symbolic_.supernodes(); }

  /// Works on the current supernode for about flopBudget operations, which it reduces by what it took. True when the
  /// front is eliminated: read it with front(), then call finishFront() to go on.
  bool eliminate(double& flopBudget);
  const double* front() const { return stack_.get() + frontBase_; }
  const double* inverse() const { return inverse_.data(); }  // of its diagonal tiles
  void finishFront();

  int regularisedPivots() const { return regularised_; }
  /// Position of the first pivot that was negative or not finite, or -1.
  int failedPosition() const { return failed_; }
  double flopsDone() const { return flopsDone_; }
  std::size_t stackDoubles() const { return stackSize_; }

 private:
  void assembleFront();
  void addChild(int child, double* front);

  const SymbolicFactor& symbolic_;
  const EntryMap& map_;
  const std::vector<double>& values_;
  std::size_t stackSize_;  // doubles
  std::unique_ptr<double[]> stack_;
  std::vector<int> firstChild_, sibling_;  // last pushed child first
  std::vector<std::size_t> updateBase_;    // of each supernode whose update matrix is on the stack
  std::vector<int> local_;                 // position -> row in the current front
  std::vector<double*> target_;            // of a child's rows in the current front
  std::vector<int> column_;                // of its columns, in doubles
  std::vector<double> reference_, inverse_;
  std::size_t stackTop_ = 0, frontBase_ = 0;
  int supernode_ = 0;
  int nextStrip_ = -1;  // of the current front, -1 before it is assembled
  int regularised_ = 0;
  int failed_ = -1;
  double flopsDone_ = 0.0;
};

/// Operations of the whole factorisation, as flopsDone() counts them.
double factorisationFlops(const SymbolicFactor& symbolic);

}  // namespace shapespline
