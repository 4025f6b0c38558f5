// The dense part of the factorisation: one front, a lower triangle in strips of four rows.
//
// It lies in two places, so its update matrix is made where it stays and the rest in a place that is at hand:
//  - its columns: those of the pivots. Strip i holds rows 4i .. 4i + 3, of columns 0 .. 4i + 3 as far as these are
//  pivots';
//  - its update matrix: what is below and right of the pivots, in strips that are numbered and begin at zero again.
// A strip has four doubles a column, so a 4 x 4 tile is contiguous, and strips are what the kernels stream.
// Pivots fill whole strips: before the first of them stand up to three of padding, rows and columns of the identity.
#pragma once

#include <algorithm>
#include <cstddef>

namespace shapespline {

/// Where strip i of a triangle starts, in doubles; also the size of a triangle of i strips.
constexpr std::size_t stripOffset(std::size_t i) { return 8 * i * (i + 1); }

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
  /// Of a front with this number of pivots.
  explicit constexpr Pivots(int columns) : strips(stripsFor(columns)), padding(4 * strips - columns) {}

  /// Where strip i of the pivots' columns starts, in doubles; also the size of these columns in i strips.
  constexpr std::size_t stripAt(int i) const {
    const int inTriangle = std::min(i, strips);
    return stripOffset(inTriangle) + stripSize(strips) * (i - inTriangle);
  }
  constexpr std::size_t stripSize(int i) const { return 16 * static_cast<std::size_t>(std::min(i + 1, strips)); }
};

/// Eliminates the pivots of a front, for the rows of strips begin ... end - 1; strips before begin must be done.
/// reference[c] is the matrix's diagonal entry for column c of the front (1 for padding), inverse has room for 16
/// doubles a pivot strip: the inverted diagonal tiles, row by row. The update matrix is written, not read: what the
/// front starts from there is to be added afterwards.
void eliminateStrips(double* columns, double* update, Pivots pivots, int begin, int end, const double* reference,
                     double* inverse, PivotReport& report);

/// Floating-point operations (a multiplication and an addition are two) of that call.
double eliminationFlops(Pivots pivots, int begin, int end);

}  // namespace shapespline
