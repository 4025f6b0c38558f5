// The stored factor and the solve. The cost of a solve is reading the factor from memory.
#pragma once

#include <vector>

#include "core/base/fork_join.h"
#include "core/sparse/panel_layout.h"

namespace shapespline {

/// The factor L of a matrix in Scalar (float or double), for solving with (x, y, z, pad) vectors. A panel is stored in
/// the order of the forward solve; the backward solve reads it backwards:
/// - its triangle, four rows at a time: the rest of the rows before the diagonal block, column by column, then the
///   inverse of the diagonal block (lower triangle, row by row). The first block may have fewer rows;
/// - the rows below, in groups of eight with a last group of four, each column by column. Padding rows are zero.
/// Four rows of one column form one vector that multiplies x, y and z at once, so no lane is wasted on the padding.
template <class Scalar>
class PanelFactor : public PanelLayout {
 public:
  /// Allocates the factor.
  void allocate(const SymbolicFactor& symbolic);

  /// Copies supernode s from the columns of its eliminated front and its inverted diagonal tiles (see dense_front.h).
  /// Pivots too small for Scalar are not detected here.
  void store(const SymbolicFactor& symbolic, int s, const double* columns, const double* inverse);

  /// Solves L Lᵀ x = b in place: (x, y, z, pad) per unknown in elimination order. The pads are scratch. `x` has length
  /// paddedSize() unknowns. Those beyond the matrix's size are scratch.
  void solve(Scalar* x, ForkJoin* forkJoin = nullptr) const;

  std::size_t entries() const { return values_.size(); }

 private:
  [[gnu::noinline]] void forward(int part, Scalar* x) const;
  [[gnu::noinline]] void backward(int part, Scalar* x) const;

  std::vector<Scalar> values_;
};

extern template class PanelFactor<float>;
extern template class PanelFactor<double>;

}  // namespace shapespline
