// The prefactored solver: analyse once, factor once, then solve three right-hand sides for every frame.
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
  std::int64_t factorBytes = 0;    ///< factor bytes read by one sweep of a solve
  std::int64_t indexBytes = 0;     ///< row lists of the panels, read equally often
  std::int64_t workBytes = 0;      ///< peak size of the factorisation's stack
  double flops = 0.0;              ///< operations of one factorisation
  int supernodes = 0;
  int regularisedPivots = 0;  ///< pivots that were zero to rounding and replaced
};

/// Supernodal multifrontal Cholesky factorisation P A Pᵀ = L Lᵀ of a sparse symmetric positive definite matrix.
///
/// A pivot that is zero to rounding, such as the last pivot of a floating component of a Laplacian, is replaced by its
/// diagonal entry, which pins that unknown to zero. stats() counts such pivots.
class Cholesky {
 public:
  Cholesky();
  ~Cholesky();
  Cholesky(Cholesky&&) noexcept;
  Cholesky& operator=(Cholesky&&) noexcept;

  /// Finds the elimination order and the factor's structure, and drops any earlier factor. coordinates: one position
  /// per unknown for a better order of large systems, or empty. onProgress: fraction of the analysis, below 1. order:
  /// the result of fillReducingOrder() (ordering.h) for this matrix, used if it is a permutation of the unknowns. Error
  /// if the matrix is malformed or not finite, or the number of coordinates is wrong.
  Status analyse(const SymmetricMatrix& matrix, std::span<const Vec3> coordinates, Precision precision,
                 const FractionReport& onProgress = {}, std::span<const int> order = {});

  /// Starts a factorisation of a matrix with the analysed pattern. Error if the pattern differs or a value is not
  /// finite.
  Status beginFactorise(const SymmetricMatrix& matrix);

  /// Continues for about flopBudget operations and returns true while more remain. The chunk size does not affect the
  /// result.
  bool factoriseSome(std::int64_t flopBudget);

  /// In [0, 1]; 1 when complete.
  double factoriseProgress() const;

  /// Error NotPositiveDefinite if a pivot was negative. error.row is its unknown in the matrix's numbering.
  Status factoriseStatus() const;

  /// Runs beginFactorise and factoriseSome to completion.
  Status factorise(const SymmetricMatrix& matrix);

  /// Position of each unknown of the matrix in the vectors of solve().
  std::span<const int> eliminationPosition() const;

  /// Length of the vectors of solve() in unknowns: the matrix's size plus scratch space.
  int paddedSize() const;

  /// Solves A x = b in place for three right-hand sides: (x, y, z, pad) of every unknown in elimination order, 4 *
  /// paddedSize() numbers, 16-byte aligned. The pads are scratch. Requires a factorisation without error, with the
  /// precision given to analyse(). Allocates nothing and changes only its argument. One or two threads give the same
  /// bits.
  void solve(float* xyzp, ForkJoin* forkJoin = nullptr) const;
  void solve(double* xyzp, ForkJoin* forkJoin = nullptr) const;

  CholeskyStats stats() const;

 private:
  struct State;
  std::unique_ptr<State> state_;
};

}  // namespace shapespline
