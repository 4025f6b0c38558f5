// Solves with CHOLMOD, with its fastest settings for such systems: METIS ordering, and supernodes with BLAS. native.ts
// sets the environment to one thread.
#include "solver.h"

#ifdef SHAPESPLINE_CHOLMOD
#include <memory>

#include <cholmod.h>
#endif

namespace shapespline::bench {

#ifdef SHAPESPLINE_CHOLMOD

namespace {

struct Common : cholmod_common {
  Common() {
    cholmod_start(this);
    supernodal = CHOLMOD_SUPERNODAL;
    nmethods = 1;
    method[0].ordering = CHOLMOD_METIS;
  }
  ~Common() { cholmod_finish(this); }
  Common(const Common&) = delete;
  Common& operator=(const Common&) = delete;
};

// Views of Eigen's arrays; CHOLMOD only reads them.
cholmod_sparse lowerTriangle(const Eigen::SparseMatrix<double>& matrix) {
  cholmod_sparse view{};
  view.nrow = view.ncol = static_cast<std::size_t>(matrix.cols());
  view.nzmax = static_cast<std::size_t>(matrix.nonZeros());
  view.p = const_cast<int*>(matrix.outerIndexPtr());
  view.i = const_cast<int*>(matrix.innerIndexPtr());
  view.x = const_cast<double*>(matrix.valuePtr());
  view.stype = -1;
  view.itype = CHOLMOD_INT, view.xtype = CHOLMOD_REAL, view.dtype = CHOLMOD_DOUBLE;
  view.sorted = view.packed = 1;
  return view;
}

cholmod_dense columns(const Eigen::MatrixX3d& matrix) {
  cholmod_dense view{};
  view.nrow = view.d = static_cast<std::size_t>(matrix.rows());
  view.ncol = 3;
  view.nzmax = 3 * view.nrow;
  view.x = const_cast<double*>(matrix.data());
  view.xtype = CHOLMOD_REAL, view.dtype = CHOLMOD_DOUBLE;
  return view;
}

// The solution and scratch memory of cholmod_solve2, reused by later solves.
struct Solution {
  explicit Solution(Common& common) : common(common) {}
  ~Solution() { cholmod_free_dense(&x, &common), cholmod_free_dense(&y, &common), cholmod_free_dense(&e, &common); }
  Solution(const Solution&) = delete;
  Solution& operator=(const Solution&) = delete;

  Common& common;
  cholmod_dense *x = nullptr, *y = nullptr, *e = nullptr;
};

}  // namespace

std::optional<SolverRound> solveByCholmod(const KnownSystem& system) {
  Common common;
  SolverRound round;
  cholmod_sparse a = lowerTriangle(system.matrix);
  cholmod_dense b = columns(system.b);
  Stopwatch watch;
  const auto release = [&](cholmod_factor* factor) { cholmod_free_factor(&factor, &common); };
  const std::unique_ptr<cholmod_factor, decltype(release)> factor(cholmod_analyze(&a, &common), release);
  round.orderMs = watch.lap();
  if (!factor) return {};
  round.factorMs = medianMs([&] { cholmod_factorize(&a, factor.get(), &common); });
  if (common.status != CHOLMOD_OK) return {};
  Solution solution(common);
  round.solveMs = medianMs([&] {
    cholmod_solve2(CHOLMOD_A, factor.get(), &b, nullptr, &solution.x, nullptr, &solution.y, &solution.e, &common);
  });
  if (!solution.x) return {};
  round.entries = static_cast<std::int64_t>(common.lnz);
  round.bytes = static_cast<std::int64_t>(factor->xsize * sizeof(double) + factor->ssize * sizeof(int));
  round.error = system.errorOf(Eigen::Map<const Eigen::MatrixX3d>(static_cast<const double*>(solution.x->x),
                                                                  static_cast<Eigen::Index>(solution.x->nrow), 3));
  return round;
}

#else

std::optional<SolverRound> solveByCholmod(const KnownSystem&) { return {}; }

#endif

}  // namespace shapespline::bench
