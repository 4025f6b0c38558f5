// The second system: vertices from face gradients (paper section 4.2). Its matrix is the reference pose's cotangent
// Laplacian, constant for a sequence, so that a frame costs one back-substitution.
#pragma once

#include <functional>
#include <vector>

#include "core/sparse/cholesky.h"
#include "core/mesh/mesh.h"
#include "core/base/status.h"

namespace shapespline {

/// Cotangent Laplacian of the faces that have area, over the welded vertices that such a face holds. One vertex of each
/// piece is left out (it is tied to zero), which makes the matrix positive definite.
struct CotangentLaplacian {
  SymmetricMatrix matrix;
  std::vector<int> unknown;      ///< of each vertex; -1 where it is tied or loose
  std::vector<Vec3> coordinates; ///< reference position of each unknown
};

CotangentLaplacian cotangentLaplacian(const std::vector<Triangle>& faces, const std::vector<char>& hasArea,
                                      const Pieces& pieces, const Positions& reference, const FractionReport& onProgress = {});

/// The factored system and where each vertex lies in its vectors.
class PoissonSystem {
 public:
  /// Finds the order of elimination. onProgress: called at least a few times a second on large meshes, as below.
  Status order(const CotangentLaplacian& laplacian, Precision precision, const FractionReport& onProgress);

  /// Factorises the matrix that was ordered.
  Status factorise(const CotangentLaplacian& laplacian, const FractionReport& onProgress);

  /// Slot of each vertex in right-hand sides and solutions; dump() for tied and loose ones.
  const std::vector<int>& slot() const { return slot_; }
  int dump() const { return solver_.paddedSize(); }
  /// Length of the vectors, in slots: the solver's and the dump, which reads as zero after solve().
  int size() const { return solver_.paddedSize() + 1; }
  /// The slots that vertices are in come first.
  int unknowns() const { return static_cast<int>(solver_.eliminationPosition().size()); }

  /// In place; 4 * size() numbers.
  template <class Real>
  void solve(Real* xyzp, Crew* crew = nullptr) const {
    solver_.solve(xyzp, crew);
    for (int i = 0; i < 4; ++i) xyzp[4 * static_cast<std::size_t>(dump()) + i] = 0;
  }

  /// Solves A x = b to double accuracy on a factor in single precision: residuals in double, corrections in single (Wilkinson
  /// 1963), from the x given until a correction is small beside `extent`. 4 * size() numbers each; the pads of b must be
  /// zero, those of x are kept. Only with Precision::Exact.
  void refine(const double* b, double* x, double extent, Crew* crew = nullptr);

  CholeskyStats stats() const { return solver_.stats(); }

 private:
  void keepMatrix(const SymmetricMatrix& matrix);
  void residual(const double* b, const double* x);

  Cholesky solver_;
  Precision precision_ = Precision::Single;
  SymmetricMatrix bySlot_;         // with Precision::Exact: the matrix in elimination order
  std::vector<double> residual_;   // scratch
  std::vector<float, Eigen::aligned_allocator<float>> correction_;
  std::vector<int> slot_;
};

}  // namespace shapespline
