// The stored factor and the solve, which is all about streaming it through the processor.
#pragma once

#include <cstddef>
#include <vector>

#include "core/symbolic.h"

namespace shapespline {

/// The factor L of a matrix, in Scalar (float or double), for solving with vectors of four lanes an unknown.
/// A supernode's columns are cut into panels of at most kWidth columns. A panel is, in the order in which the forward
/// solve reads it: the inverse of its diagonal block (lower triangle, row-major), then every row below, row-major.
template <class Scalar>
class PanelFactor {
 public:
  static constexpr int kWidth = 8;

  /// Makes room for the factor. The symbolic factor must outlive this.
  void allocate(const SymbolicFactor& symbolic);

  /// Takes over supernode s from its eliminated front (see dense_front.h).
  void store(int s, const double* front);

  /// Solves L Lᵀ x = b in place, four lanes an unknown in elimination order. `x` has length paddedSize() unknowns, those
  /// beyond the matrix's size are scratch.
  void solve(Scalar* x) const;

  int paddedSize() const { return paddedSize_; }
  std::size_t entries() const { return values_.size(); }

 private:
  void forward(Scalar* x) const;
  void backward(Scalar* x) const;

  const SymbolicFactor* symbolic_ = nullptr;
  std::vector<Scalar> values_;
  std::vector<std::size_t> start_;  // of each supernode in values_
  int paddedSize_ = 0;
};

extern template class PanelFactor<float>;
extern template class PanelFactor<double>;

}  // namespace shapespline
