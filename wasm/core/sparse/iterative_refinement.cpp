#include "core/sparse/iterative_refinement.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <utility>

#include "core/base/simd.h"

namespace shapespline {

namespace {

// A correction leaves about 1e-5 of itself as error, so the last correction leaves less than 1e-11 of the extent.
constexpr double smallCorrection = 1e-6;
// Three corrections are typical. Systems close to the limit of single precision take more.
constexpr int maxCorrections = 12;

}  // namespace

IterativeRefinement::IterativeRefinement(const SymmetricMatrix& matrix, const Cholesky& solver) {
  const auto position = solver.eliminationPosition();
  EntryMap map = mapEntries(matrix, {position.begin(), position.end()});
  matrix_ = {matrix.size, std::move(map.start), {}, {}};
  matrix_.row.reserve(map.item.size());
  matrix_.value.reserve(map.item.size());
  for (const auto& [row, source] : map.item) {
    matrix_.row.push_back(row);
    matrix_.value.push_back(matrix.value[source]);
  }
}

// residual -= A x
void IterativeRefinement::subtractProduct(const double* x, double* residual) const {
  const auto at = [](auto* p, int i) { return p + 4 * static_cast<std::ptrdiff_t>(i); };
  for (int column = 0; column < matrix_.size; ++column) {
    const Double4 xc = Double4::load(at(x, column));
    Double4 sum = Double4::zero();
    for (int i = matrix_.columnStart[column]; i < matrix_.columnStart[column + 1]; ++i) {
      const int row = matrix_.row[i];
      const Double4 value = Double4::splat(matrix_.value[i]);
      sum = sum + value * Double4::load(at(x, row));
      if (row == column) continue;
      double* r = at(residual, row);
      (Double4::load(r) - value * xc).store(r);
    }
    double* r = at(residual, column);
    (Double4::load(r) - sum).store(r);
  }
}

void IterativeRefinement::solve(const Cholesky& solver, const double* b, double* x, double extent, Scratch& scratch,
                                ForkJoin* forkJoin) const {
  const std::size_t length = 4 * static_cast<std::size_t>(solver.paddedSize());
  scratch.correction.resize(length);
  assert([&] {  // the pads of b must be zero
    for (std::size_t i = 3; i < 4 * static_cast<std::size_t>(matrix_.size); i += 4)
      if (b[i] != 0) return false;
    return true;
  }());
  for (int step = 0; step < maxCorrections; ++step) {
    scratch.residual.assign(b, b + length);
    subtractProduct(x, scratch.residual.data());
    std::copy(scratch.residual.begin(), scratch.residual.end(), scratch.correction.begin());
    solver.solve(scratch.correction.data(), forkJoin);
    double largest = 0;
    for (std::size_t i = 0; i < 4 * static_cast<std::size_t>(matrix_.size); ++i) {
      if (i % 4 == 3) continue;
      x[i] += scratch.correction[i];
      largest = std::max(largest, std::abs(static_cast<double>(scratch.correction[i])));
    }
    if (largest <= smallCorrection * extent) return;
  }
}

}  // namespace shapespline
