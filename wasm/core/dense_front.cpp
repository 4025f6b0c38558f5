#include "core/dense_front.h"

#include <algorithm>
#include <cmath>

#include "core/out_of_line.h"
#include "core/simd.h"

namespace shapespline {

namespace {

// Relative to the diagonal entry: below the first a pivot is rounding noise of a semi-definite matrix, below the second
// the matrix is indefinite. Schur complements of a positive semi-definite matrix never exceed its diagonal.
constexpr double kSemidefinite = 1e-13;
constexpr double kIndefinite = -1e-8;

// tile -= rows * columnsᵀ over the first `depth` columns of two strips.
void updateTile(const double* rows, const double* columns, int depth, double* tile) {
  Double2 t00 = Double2::load(tile), t10 = Double2::load(tile + 2);
  Double2 t01 = Double2::load(tile + 4), t11 = Double2::load(tile + 6);
  Double2 t02 = Double2::load(tile + 8), t12 = Double2::load(tile + 10);
  Double2 t03 = Double2::load(tile + 12), t13 = Double2::load(tile + 14);
  for (const double* end = rows + 4 * static_cast<std::ptrdiff_t>(depth); rows != end; rows += 4, columns += 4) {
    const Double2 a0 = Double2::load(rows), a1 = Double2::load(rows + 2);
    Double2 b = Double2::loadSplat(columns);
    t00 = t00 - a0 * b, t10 = t10 - a1 * b;
    b = Double2::loadSplat(columns + 1);
    t01 = t01 - a0 * b, t11 = t11 - a1 * b;
    b = Double2::loadSplat(columns + 2);
    t02 = t02 - a0 * b, t12 = t12 - a1 * b;
    b = Double2::loadSplat(columns + 3);
    t03 = t03 - a0 * b, t13 = t13 - a1 * b;
  }
  t00.store(tile), t10.store(tile + 2);
  t01.store(tile + 4), t11.store(tile + 6);
  t02.store(tile + 8), t12.store(tile + 10);
  t03.store(tile + 12), t13.store(tile + 14);
}

// tile := tile * inverseᵀ with a lower triangular 4 x 4 inverse, row-major.
void solveTile(double* tile, const double* inverse) {
  for (int half = 0; half < 2; ++half, tile += 2) {
    const Double2 c0 = Double2::load(tile), c1 = Double2::load(tile + 4);
    const Double2 c2 = Double2::load(tile + 8), c3 = Double2::load(tile + 12);
    const auto entry = [&](int i, int j) { return Double2::loadSplat(inverse + 4 * i + j); };
    (c0 * entry(0, 0)).store(tile);
    (c0 * entry(1, 0) + c1 * entry(1, 1)).store(tile + 4);
    (c0 * entry(2, 0) + c1 * entry(2, 1) + c2 * entry(2, 2)).store(tile + 8);
    (c0 * entry(3, 0) + c1 * entry(3, 1) + c2 * entry(3, 2) + c3 * entry(3, 3)).store(tile + 12);
  }
}

// Cholesky of a diagonal tile in place and its inverse; firstColumn is the tile's first column in the front.
void factorTile(double* tile, int firstColumn, const double* reference, double* inverse, PivotReport& report) {
  const auto at = [&](int r, int c) -> double& { return tile[4 * c + r]; };
  double inverseRoot[4];
  for (int c = 0; c < 4; ++c) {
    double pivot = at(c, c);
    const double scale = std::abs(reference[c]);
    if (!(pivot > kSemidefinite * scale)) {
      if (!(pivot >= kIndefinite * scale) && report.failed == -1) report.failed = firstColumn + c;
      // As if this unknown were tied to zero with the strength of its own diagonal entry: any weaker tie would let
      // rounding errors of the right-hand side through.
      pivot = scale > 0.0 ? scale : 1.0;
      ++report.regularised;
    }
    // From pivot to pivot there is one division to wait for, and no square root.
    const double reciprocal = 1.0 / pivot;
    for (int k = c + 1; k < 4; ++k)
      for (int r = k; r < 4; ++r) at(r, k) -= at(r, c) * (at(k, c) * reciprocal);
    const double root = std::sqrt(pivot);
    inverseRoot[c] = root * reciprocal;
    at(c, c) = root;
    for (int r = c + 1; r < 4; ++r) at(r, c) *= inverseRoot[c];
    for (int r = 0; r < c; ++r) at(r, c) = 0.0;
  }
  for (int c = 0; c < 4; ++c) {
    for (int r = 0; r < 4; ++r) {
      double sum = r == c ? 1.0 : 0.0;
      for (int p = c; p < r; ++p) sum -= at(r, p) * inverse[4 * p + c];
      inverse[4 * r + c] = r < c ? 0.0 : sum * inverseRoot[r];
    }
  }
}

// Strips that are eliminated together: each strip above is read once for all of them, and they fit a level-2 cache.
constexpr int kGroup = 8;

// Updates the tiles in column j of the strips begin ... end - 1, not above the diagonal, by columns first ... last - 1.
void updateColumn(double* front, int j, int begin, int end, int first, int last) {
  const double* columns = front + stripOffset(j) + 4 * first;
  double* rows = front + stripOffset(begin);
  for (int i = begin; i < end; ++i, rows += 16 * static_cast<std::ptrdiff_t>(i))
    updateTile(rows + 4 * first, columns, last - first, rows + 16 * static_cast<std::ptrdiff_t>(j));
}

// Turns the updated tiles in pivot column j of the strips begin ... end - 1 into the factor's.
void solveColumn(double* front, int j, int begin, int end, const double* inverse) {
  for (int i = begin; i < end; ++i) solveTile(front + stripOffset(i) + 16 * static_cast<std::ptrdiff_t>(j), inverse);
}

}  // namespace

void eliminateStrips(double* front, Pivots pivots, int begin, int end, const double* reference, double* inverse,
                     PivotReport& report) {
  const auto update = outOfLine(updateColumn);
  const auto solve = outOfLine(solveColumn);
  const auto factor = outOfLine(factorTile);
  for (int group = begin; group < end; group += kGroup) {
    const int groupEnd = std::min(end, group + kGroup);
    for (int j = 0; j < groupEnd; ++j) {
      if (j > 0) update(front, j, std::max(j, group), groupEnd, pivots.padding, 4 * std::min(j, pivots.strips));
      if (j >= pivots.strips) continue;
      double* const inverted = inverse + 16 * j;
      double* const diagonal = front + stripOffset(j) + 16 * static_cast<std::ptrdiff_t>(j);
      if (j >= group) factor(diagonal, 4 * j, reference + 4 * j, inverted, report);
      solve(front, j, std::max(j + 1, group), groupEnd, inverted);
    }
  }
}

double eliminationFlops(Pivots pivots, int begin, int end) {
  // Strip i multiplies its tiles j <= i at depth 4 min(j, strips), less the padding: 2 * 16 * depth operations a tile.
  double flops = 0.0;
  for (int i = begin; i < end; ++i) {
    const double triangle = std::min(i, pivots.strips), rest = std::max(0, i + 1 - pivots.strips);
    flops += 128.0 * (triangle * (triangle + 1) / 2 + pivots.strips * rest) - 32.0 * pivots.padding * i;
  }
  return flops;
}

}  // namespace shapespline
