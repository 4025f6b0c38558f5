// The stored factor and the solve, which is all about streaming it through the processor.
#pragma once

#include <vector>

#include "core/base/fork_join.h"
#include "core/sparse/panel_layout.h"

namespace shapespline {

/// The factor L of a matrix, in Scalar (float or double), for solving with (x, y, z, pad) vectors. A panel is stored in
/// the order in which the forward solve reads it and the backward solve reads it backwards:
///  - its triangle, four rows at a time: what is left of the diagonal block, column by column, then the inverse of the
///    diagonal block (lower triangle, row by row). The first block may have fewer rows;
///  - the rows below, eight at a time, then a last group of four, each column by column. Rows that fill up a group are
///  zero.
/// Four rows of one column are one vector that multiplies x, y and z at once: no lane is wasted on the padding.
template <class Scalar>
class PanelFactor : public PanelLayout {
 public:
  /// Makes room for the factor.
  void allocate(const SymbolicFactor& symbolic);

  /// Takes over supernode s from the columns of its eliminated front and its inverted diagonal tiles (see
  /// dense_front.h). The first column of which a pivot is too small for Scalar is the factor's problem, not noticed
  /// here.
  void store(const SymbolicFactor& symbolic, int s, const double* columns, const double* inverse);

  /// Solves L Lᵀ x = b in place, (x, y, z, pad) an unknown in elimination order; the padding is scratch. `x` has
  /// length paddedSize() unknowns, those beyond the matrix's size are scratch.
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
