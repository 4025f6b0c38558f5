// The dense part of the factorisation: one front, a lower triangle in strips of four rows.
//
// Strip i holds rows 4i .. 4i + 3 and columns 0 .. 4i + 3, four doubles a column: entry (r, c) is at
// stripOffset(r / 4) + 4 c + r % 4. A 4 x 4 tile is then contiguous, and strips are what the kernels stream.
// Pivots fill whole strips: before the first of them stand up to three of padding, rows and columns of the identity.
#pragma once

#include <cstddef>

namespace shapespline {

/// Where strip i starts, in doubles; also the size of a front of i strips.
constexpr std::size_t stripOffset(std::size_t i) { return 8 * i * (i + 1); }

/// Where entry (row, column) of a front is, row >= column.
constexpr std::size_t placeInFront(int row, int column) {
  return stripOffset(static_cast<std::size_t>(row) / 4) + 4 * static_cast<std::size_t>(column) + row % 4;
}

/// Strips that n rows take.
constexpr int stripsFor(int n) { return (n + 3) / 4; }

/// How the pivots of one front went. A pivot is judged against its own diagonal entry in the matrix.
struct PivotReport {
  int regularised = 0;
  int failed = -1;  ///< column in the front of the first negative pivot or one that is not finite, or -1
};

/// The pivots of a front: `strips` strips of them, of which the first has `padding` columns that are none.
struct Pivots {
  int strips, padding;
  /// Of a front with so many pivots.
  explicit constexpr Pivots(int columns) : strips(stripsFor(columns)), padding(4 * strips - columns) {}
};

/// Eliminates the pivots of a front, for the rows of strips begin ... end - 1; strips before begin must be done.
/// reference[c] is the matrix's diagonal entry for column c of the front (1 for padding), inverse has room for 16 doubles a
/// pivot strip: the inverted diagonal tiles, row by row. Rows below the pivots are left with the update matrix.
void eliminateStrips(double* front, Pivots pivots, int begin, int end, const double* reference, double* inverse,
                     PivotReport& report);

/// Floating-point operations (a multiplication and an addition are two) of that call.
double eliminationFlops(Pivots pivots, int begin, int end);

}  // namespace shapespline
