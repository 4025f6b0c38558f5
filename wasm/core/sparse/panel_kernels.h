// The two inner loops of the solve: one panel of the factor (see panel_layout.h) forward and backward.
#pragma once

#include <cstddef>

namespace shapespline {

/// Rows of a panel's first triangle block. All other blocks have four.
constexpr int firstBlock(int columns) { return (columns - 1) % 4 + 1; }

/// Size of a panel with `columns` columns and `rows` rows below (a multiple of four), in numbers.
constexpr std::size_t panelEntries(int columns, int rows) {
  const std::size_t first = static_cast<std::size_t>(firstBlock(columns));
  std::size_t entries = first * (first + 1) / 2 + static_cast<std::size_t>(columns) * static_cast<std::size_t>(rows);
  for (std::size_t c = first; c < static_cast<std::size_t>(columns); c += 4) entries += 4 * c + 10;
  return entries;
}

/// Works on the vector x (four numbers per unknown). The panel's own unknowns start at `first`; the rows below are
/// row[0 .. rows - 1].
template <class Scalar>
using PanelKernel = void (*)(const Scalar* values, int columns, const int* row, int rows, Scalar* x, int first);

template <class Scalar>
struct PanelKernels {
  PanelKernel<Scalar> forward, backward;
};

/// Called through pointers (see core/base/no_inline_call.h).
template <class Scalar>
PanelKernels<Scalar> panelKernels();

}  // namespace shapespline
