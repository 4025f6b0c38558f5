// The prefactored solver: analyse once, factor once, then solve with three right-hand sides for every frame.
#pragma once

#include <cstdint>
#include <memory>
#include <span>

#include "core/base/fork_join.h"
#include "core/base/precision.h"
#include "core/base/progress.h"
#include "core/base/status.h"
#include "core/base/types.h"
#include "core/sparse/sparse_matrix.h"

namespace shapespline {

struct CholeskyStats {
  std::int64_t factorEntries = 0;  ///< stored numbers, zeros of merged supernodes included
  std::int64_t factorBytes = 0;    ///< what one sweep of a solve reads of them
  std::int64_t indexBytes = 0;     ///< row lists of its panels, read as often
  std::int64_t workBytes = 0;      ///< largest size of the factorisation's stack
  double flops = 0.0;              ///< of one factorisation
  int supernodes = 0;
  int regularisedPivots = 0;  ///< pivots that were zero to rounding and were replaced
};

/// Supernodal multifrontal Cholesky factorisation P A Pᵀ = L Lᵀ of a sparse symmetric positive definite matrix.
///
/// A pivot that is zero to rounding, as the last one of a floating component of a Laplacian, is replaced by its
/// diagonal entry, which pins that unknown to zero; stats() counts such pivots.
class Cholesky {
 public:
  Cholesky();
  ~Cholesky();
  Cholesky(Cholesky&&) noexcept;
  Cholesky& operator=(Cholesky&&) noexcept;

  /// Finds the elimination order and the factor's structure; drops any earlier factor. coordinates: one position per
  /// unknown, which makes for a better order of a large system, or empty. Error if the matrix is malformed or not
  /// finite, or the coordinates are of another number. onProgress: fraction of the analysis, below 1. order: what
  /// fillReducingOrder() (ordering.h) found for this matrix elsewhere, used if it is a permutation of the unknowns.
  Status analyse(const SymmetricMatrix& matrix, std::span<const Vec3> coordinates, Precision precision,
                 const FractionReport& onProgress = {}, std::span<const int> order = {});

  /// Starts a factorisation of a matrix with the analysed pattern. Error if the pattern differs or a value is not
  /// finite.
  Status beginFactorise(const SymmetricMatrix& matrix);

  /// Goes on with it for about flopBudget operations; true if there is more to do. The chunks do not change the result.
  bool factoriseSome(std::int64_t flopBudget);

  /// In [0, 1], 1 when nothing is left to do.
  double factoriseProgress() const;

  /// Error NotPositiveDefinite if a pivot was negative; error.row is its unknown, in the matrix's numbering.
  Status factoriseStatus() const;

  /// beginFactorise and factoriseSome to the end.
  Status factorise(const SymmetricMatrix& matrix);

  /// Where each unknown of the matrix lies in the vectors of solve().
  std::span<const int> eliminationPosition() const;

  /// Length of the vectors of solve(), in unknowns: the matrix's size and some scratch space behind it.
  int paddedSize() const;

  /// Solves A x = b in place for three right-hand sides: (x, y, z, pad) of every unknown in elimination order,
  /// 4 * paddedSize() numbers, 16-byte aligned. Only for the precision given to analyse(), after a factorisation
  /// without error. The pads are scratch. Allocates nothing and changes nothing but its argument, in one thread or two
  /// to the same bits.
  void solve(float* xyzp, ForkJoin* forkJoin = nullptr) const;
  void solve(double* xyzp, ForkJoin* forkJoin = nullptr) const;

  CholeskyStats stats() const;

 private:
  struct State;
  std::unique_ptr<State> state_;
};

}  // namespace shapespline
