// The second system: vertices from face gradients (paper section 4.2). The matrix is the reference pose's cotangent
// Laplacian. It is constant for a sequence, so a frame costs one solve with the stored factor.
#pragma once

#include <optional>
#include <vector>

#include "core/base/status.h"
#include "core/base/stopwatch.h"
#include "core/mesh/mesh.h"
#include "core/sparse/cholesky.h"
#include "core/sparse/iterative_refinement.h"

namespace shapespline {

/// Cotangent Laplacian of the faces with area, for their welded vertices. One vertex of each component is omitted
/// (pinned to zero), which makes the matrix positive definite.
struct CotangentLaplacian {
  SymmetricMatrix matrix;
  std::vector<int> unknown;       ///< unknown of each vertex, or -1 if pinned or loose
  std::vector<Vec3> coordinates;  ///< reference position of each unknown
};

CotangentLaplacian cotangentLaplacian(const std::vector<Triangle>& faces, const std::vector<char>& hasArea,
                                      const Components& components, const Positions& reference,
                                      const FractionReport& onProgress = {});

/// The default elimination order of PoissonSystem: order[p] is the unknown at position p.
std::vector<int> eliminationOrder(const CotangentLaplacian& laplacian);

/// Waits for an order of the given number of unknowns from another worker; may be null. Returns an empty list without
/// an order, which is not an error.
using OrderSource = std::vector<int> (*)(int unknowns);

/// The factored system and the position of each vertex in its vectors. Immutable.
class PoissonSystem {
 public:
  /// Wall times, ms.
  struct Times {
    double order = 0, factor = 0;
  };

  /// Finds an elimination order unless `order` provides one of the right size, then factors. On large meshes, the
  /// reports are called several times per second. Error: the solver's.
  static Result<PoissonSystem> create(const CotangentLaplacian& laplacian, Precision precision, OrderSource order,
                                      const FractionReport& ordering, const FractionReport& factorising);

  /// Slot of each vertex in right-hand sides and solutions. Pinned and loose vertices have trashSlot().
  const std::vector<int>& slot() const { return slot_; }
  int trashSlot() const { return solver_.paddedSize(); }
  /// Length of the vectors in slots: the solver's size plus the trashSlot, which is zero after solve().
  int size() const { return solver_.paddedSize() + 1; }
  /// Number of slots for vertices, which come first.
  int unknowns() const { return static_cast<int>(solver_.eliminationPosition().size()); }

  /// Solves in place; 4 * size() numbers.
  template <class Real>
  void solve(Real* xyzp, ForkJoin* forkJoin = nullptr) const {
    solver_.solve(xyzp, forkJoin);
    for (int i = 0; i < 4; ++i) xyzp[4 * static_cast<std::size_t>(trashSlot()) + i] = 0;
  }

  /// Solves to double accuracy from the initial guess x (iterative_refinement.h); 4 * size() numbers each. Requires
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
  std::optional<IterativeRefinement> refinement_;  // only with Precision::Exact
  std::vector<int> slot_;
  Times times_;
};

}  // namespace shapespline
