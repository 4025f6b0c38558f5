// The second system: vertices from face gradients (paper section 4.2). Its matrix is the reference pose's cotangent
// Laplacian, constant for a sequence, so a frame costs one back-substitution.
#pragma once

#include <optional>
#include <vector>

#include "core/base/status.h"
#include "core/base/stopwatch.h"
#include "core/mesh/mesh.h"
#include "core/sparse/cholesky.h"
#include "core/sparse/iterative_refinement.h"

namespace shapespline {

/// Cotangent Laplacian of the faces that have area, over the welded vertices that such a face holds. One vertex of each
/// component is left out (it is pinned to zero), which makes the matrix positive definite.
struct CotangentLaplacian {
  SymmetricMatrix matrix;
  std::vector<int> unknown;       ///< of each vertex; -1 where it is pinned or loose
  std::vector<Vec3> coordinates;  ///< reference position of each unknown
};

CotangentLaplacian cotangentLaplacian(const std::vector<Triangle>& faces, const std::vector<char>& hasArea,
                                      const Components& components, const Positions& reference,
                                      const FractionReport& onProgress = {});

/// The order in which PoissonSystem eliminates the unknowns where it is given none: order[p] is the one at position p.
std::vector<int> eliminationOrder(const CotangentLaplacian& laplacian);

/// Waits for an order of this many unknowns from elsewhere, or null. Empty if there is none, which is not a failure.
using OrderSource = std::vector<int> (*)(int unknowns);

/// The factored system and where each vertex lies in its vectors. Immutable.
class PoissonSystem {
 public:
  /// Wall times, ms.
  struct Times {
    double order = 0, factor = 0;
  };

  /// Finds the order of elimination where `order` has none for as many unknowns, then factors. The reports are called
  /// at least a few times a second on large meshes. Error: that of the solver.
  static Result<PoissonSystem> create(const CotangentLaplacian& laplacian, Precision precision, OrderSource order,
                                      const FractionReport& ordering, const FractionReport& factorising);

  /// Slot of each vertex in right-hand sides and solutions; trashSlot() for pinned and loose ones.
  const std::vector<int>& slot() const { return slot_; }
  int trashSlot() const { return solver_.paddedSize(); }
  /// Length of the vectors, in slots: the solver's and the trashSlot, which reads as zero after solve().
  int size() const { return solver_.paddedSize() + 1; }
  /// The slots that vertices are in come first.
  int unknowns() const { return static_cast<int>(solver_.eliminationPosition().size()); }

  /// In place; 4 * size() numbers.
  template <class Real>
  void solve(Real* xyzp, ForkJoin* forkJoin = nullptr) const {
    solver_.solve(xyzp, forkJoin);
    for (int i = 0; i < 4; ++i) xyzp[4 * static_cast<std::size_t>(trashSlot()) + i] = 0;
  }

  /// The same to double accuracy, from the given x (iterative_refinement.h); 4 * size() numbers each. Only with
  /// Precision::Exact.
  void refine(const double* b, double* x, double extent, IterativeRefinement::Scratch& scratch,
              ForkJoin* forkJoin = nullptr) const {
    refinement_->solve(solver_, b, x, extent, scratch, forkJoin);
  }

  CholeskyStats stats() const { return solver_.stats(); }
  const Times& times() const { return times_; }

 private:
  PoissonSystem() = default;
  Status factorise(const CotangentLaplacian& laplacian, const FractionReport& onProgress);

  Cholesky solver_;
  std::optional<IterativeRefinement> refinement_;  // with Precision::Exact
  std::vector<int> slot_;
  Times times_;
};

}  // namespace shapespline
