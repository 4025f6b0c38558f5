// The dense part of the factorisation: one front, a lower triangle in strips of four rows.
//
// A front has two parts in separate memory, so the update matrix is computed at its final position:
// - the pivots' columns: strip i holds rows 4i .. 4i + 3, of columns 0 .. 4i + 3 as far as these are pivots;
// - the update matrix, below and right of the pivots, in strips numbered from zero again.
// A strip has four doubles per column, so a 4 x 4 tile is contiguous, and kernels stream whole strips.
// Pivots fill whole strips. Up to three rows and columns of the identity precede them as padding.
#pragma once

#include <algorithm>
#include <cstddef>

namespace shapespline {

/// Offset of strip i in a triangle, in doubles; also the size of a triangle of i strips.
constexpr std::size_t stripOffset(std::size_t i) { return 8 * i * (i + 1); }

/// Number of strips for n rows.
constexpr int stripsFor(int n) { return (n + 3) / 4; }

/// Result of one front's elimination. A pivot is compared with its own diagonal entry in the matrix.
struct PivotReport {
  int regularised = 0;
  int failed = -1;  ///< front column of the first pivot that is negative or not finite, or -1
};

/// The pivots of a front: `strips` strips, starting with `padding` columns of padding.
struct Pivots {
  int strips, padding;
  /// For a front with this number of pivots.
  explicit constexpr Pivots(int columns) : strips(stripsFor(columns)), padding(4 * strips - columns) {}

  /// Offset of strip i in the pivots' columns, in doubles; also the size of these columns in i strips.
  constexpr std::size_t stripAt(int i) const {
    const int inTriangle = std::min(i, strips);
    return stripOffset(inTriangle) + stripSize(strips) * (i - inTriangle);
  }
  constexpr std::size_t stripSize(int i) const { return 16 * static_cast<std::size_t>(std::min(i + 1, strips)); }
};

/// Eliminates the pivots of a front for the rows of strips begin ... end - 1. Strips before begin must be complete.
/// reference[c]: the matrix's diagonal entry for column c of the front (1 for padding). inverse: receives the inverted
/// diagonal tiles row by row, 16 doubles per pivot strip. The update matrix is overwritten, so other contributions must
/// be added afterwards.
void eliminateStrips(double* columns, double* update, Pivots pivots, int begin, int end, const double* reference,
                     double* inverse, PivotReport& report);

/// Floating-point operations of eliminateStrips(). A multiply-add counts as two.
double eliminationFlops(Pivots pivots, int begin, int end);

}  // namespace shapespline
