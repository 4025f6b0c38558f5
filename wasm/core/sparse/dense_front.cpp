#include "core/sparse/dense_front.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "core/base/no_inline_call.h"
#include "core/base/simd.h"

namespace shapespline {

namespace {

// Relative to the diagonal entry: a pivot below the first limit is rounding noise of a semi-definite matrix. Below the
// second, the matrix is indefinite. Schur complements of a positive semi-definite matrix never exceed its diagonal.
constexpr double semidefinite = 1e-13;
constexpr double indefinite = -1e-8;
// Absolute: the reciprocal of a smaller number may overflow.
constexpr double smallest = std::numeric_limits<double>::min();

// A 4 x 4 tile in registers: rows 0, 1 and rows 2, 3 of each column.
struct Tile {
  Double2 a0, b0, a1, b1, a2, b2, a3, b3;

  static Tile zero() {
    const Double2 z = Double2::zero();
    return {z, z, z, z, z, z, z, z};
  }
  static Tile load(const double* p) {
    const auto at = [&](int i) { return Double2::load(p + 2 * i); };
    return {at(0), at(1), at(2), at(3), at(4), at(5), at(6), at(7)};
  }
  void store(double* p) const {
    a0.store(p);
    b0.store(p + 2);
    a1.store(p + 4);
    b1.store(p + 6);
    a2.store(p + 8);
    b2.store(p + 10);
    a3.store(p + 12);
    b3.store(p + 14);
  }
};

// The tile minus rows * columnsᵀ over the first `depth` columns of two strips.
inline Tile less(Tile t, const double* rows, const double* columns, int depth) {
  for (const double* end = rows + 4 * static_cast<std::ptrdiff_t>(depth); rows != end; rows += 4, columns += 4) {
    const Double2 a = Double2::load(rows), b = Double2::load(rows + 2);
    Double2 c = Double2::loadSplat(columns);
    t.a0 = t.a0 - a * c;
    t.b0 = t.b0 - b * c;
    c = Double2::loadSplat(columns + 1);
    t.a1 = t.a1 - a * c;
    t.b1 = t.b1 - b * c;
    c = Double2::loadSplat(columns + 2);
    t.a2 = t.a2 - a * c;
    t.b2 = t.b2 - b * c;
    c = Double2::loadSplat(columns + 3);
    t.a3 = t.a3 - a * c;
    t.b3 = t.b3 - b * c;
  }
  return t;
}

// The tile times inverseᵀ with a lower triangular 4 x 4 inverse, row-major.
inline Tile solved(Tile t, const double* inverse) {
  const auto entry = [&](int i, int j) { return Double2::loadSplat(inverse + 4 * i + j); };
  Double2 e = entry(3, 0);
  Double2 a = t.a0 * e, b = t.b0 * e;
  e = entry(3, 1);
  a = a + t.a1 * e;
  b = b + t.b1 * e;
  e = entry(3, 2);
  a = a + t.a2 * e;
  b = b + t.b2 * e;
  e = entry(3, 3);
  t.a3 = a + t.a3 * e;
  t.b3 = b + t.b3 * e;
  e = entry(2, 0);
  a = t.a0 * e;
  b = t.b0 * e;
  e = entry(2, 1);
  a = a + t.a1 * e;
  b = b + t.b1 * e;
  e = entry(2, 2);
  t.a2 = a + t.a2 * e;
  t.b2 = b + t.b2 * e;
  e = entry(1, 0);
  a = t.a0 * e;
  b = t.b0 * e;
  e = entry(1, 1);
  t.a1 = a + t.a1 * e;
  t.b1 = b + t.b1 * e;
  e = entry(0, 0);
  t.a0 = t.a0 * e;
  t.b0 = t.b0 * e;
  return t;
}

// Cholesky factorisation of a diagonal tile in place, and its inverse. firstColumn: the tile's first column in the
// front.
void factorTile(double* tile, int firstColumn, const double* reference, double* inverse, PivotReport& report) {
  const auto at = [&](int r, int c) -> double& { return tile[4 * c + r]; };
  double inverseRoot[4];
  for (int c = 0; c < 4; ++c) {
    double pivot = at(c, c);
    const double scale = std::abs(reference[c]);
    if (!(pivot > std::max(semidefinite * scale, smallest))) {
      if (!(pivot >= indefinite * scale) && report.failed == -1) report.failed = firstColumn + c;
      // Pins this unknown to zero with the strength of its own diagonal entry. A weaker pin would amplify rounding
      // errors of the right-hand side.
      pivot = scale > smallest ? scale : 1.0;
      ++report.regularised;
    }
    // Each pivot waits for one division only, and for no square root.
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

// Number of strips eliminated together. Each strip above is read once for all of them, and they fit a level-2 cache.
constexpr int groupSize = 8;

// Updates and solves the tile that follows `depth` columns from `rows` on, in strips begin ... end - 1. above: the same
// columns of the strip with the diagonal tile.
void solveColumn(double* rows, int begin, int end, Pivots pivots, const double* above, int depth,
                 const double* inverse) {
  for (int i = begin; i < end; ++i) {
    double* const tile = rows + 4 * static_cast<std::ptrdiff_t>(depth);
    solved(less(Tile::load(tile), rows, above, depth), inverse).store(tile);
    rows += pivots.stripSize(i);
  }
}

// Updates the diagonal tile with the `depth` columns before it.
void updateDiagonal(double* rows, int depth) {
  double* const tile = rows + 4 * static_cast<std::ptrdiff_t>(depth);
  less(Tile::load(tile), rows, rows, depth).store(tile);
}

// Computes strips begin ... end - 1 of the update matrix. below: its rows of the pivots' columns.
void makeUpdate(const double* below, double* update, Pivots pivots, int begin, int end) {
  const std::ptrdiff_t stride = 16 * static_cast<std::ptrdiff_t>(pivots.strips);
  const int depth = 4 * pivots.strips - pivots.padding;
  below += 4 * pivots.padding;
  for (int j = 0; j < end; ++j)
    for (int i = std::max(j, begin); i < end; ++i)
      less(Tile::zero(), below + stride * i, below + stride * j, depth)
          .store(update + stripOffset(i) + 16 * static_cast<std::ptrdiff_t>(j));
}

}  // namespace

void eliminateStrips(double* columns, double* update, Pivots pivots, int begin, int end, const double* reference,
                     double* inverse, PivotReport& report) {
  const auto solve = outOfLine(solveColumn);
  const auto diagonal = outOfLine(updateDiagonal);
  const auto factor = outOfLine(factorTile);
  const auto make = outOfLine(makeUpdate);
  for (int group = begin; group < end; group += groupSize) {
    const int groupEnd = std::min(end, group + groupSize);
    for (int j = 0; j < std::min(groupEnd, pivots.strips); ++j) {
      const int skipped = j > 0 ? pivots.padding : 0, depth = 4 * j - skipped, next = std::max(j + 1, group);
      double* const inverted = inverse + 16 * j;
      double* const above = columns + pivots.stripAt(j) + 4 * skipped;
      if (j >= group) {
        diagonal(above, depth);
        factor(above + 4 * static_cast<std::ptrdiff_t>(depth), 4 * j, reference + 4 * j, inverted, report);
      }
      solve(columns + pivots.stripAt(next) + 4 * skipped, next, groupEnd, pivots, above, depth, inverted);
    }
    if (groupEnd > pivots.strips)
      make(columns + pivots.stripAt(pivots.strips), update, pivots, std::max(0, group - pivots.strips),
           groupEnd - pivots.strips);
  }
}

double eliminationFlops(Pivots pivots, int begin, int end) {
  // Strip i multiplies its tiles j <= i at depth 4 min(j, strips), minus the padding: 2 * 16 * depth operations per
  // tile.
  double flops = 0.0;
  for (int i = begin; i < end; ++i) {
    const double triangle = std::min(i, pivots.strips), rest = std::max(0, i + 1 - pivots.strips);
    flops += 128.0 * (triangle * (triangle + 1) / 2 + pivots.strips * rest) - 32.0 * pivots.padding * i;
  }
  return flops;
}

}  // namespace shapespline
