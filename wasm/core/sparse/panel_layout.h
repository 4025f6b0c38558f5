// Cuts a factor's supernodes into panels, and the panels into parts for two threads.
#pragma once

#include <algorithm>
#include <cstddef>
#include <vector>

#include "core/sparse/dense_front.h"
#include "core/sparse/symbolic.h"

namespace shapespline {

/// A supernode's columns are cut into panels of similar width, at most `width`.
///
/// The supernode tree is cut into two parts, one per thread, and a top (subtree_partition.h). Panels are stored in that
/// order. The second part must not access the top's unknowns: its rows refer to copies beyond the matrix's size.
class PanelLayout {
 public:
  static constexpr int width = 64;

  /// Number of unknowns: the matrix's, one padding unknown per part, and the copies.
  int paddedSize() const { return size_ + 2 + static_cast<int>(top_.size()); }
  std::size_t indexBytes() const { return row_.size() * sizeof(int) + panels_.size() * sizeof(Panel); }

 protected:
  struct Panel {
    int first;  // first column
    int columns;
    int rows;            // number of rows below its triangle, a multiple of four
    std::size_t row;     // start of the rows in row_
    std::size_t values;  // start of the entries
  };

  // Returns the number of entries.
  std::size_t lay(const SymbolicFactor& symbolic);

  int size_ = 0;
  std::vector<Panel> panels_;
  // Indices into panels_: the starts of the first part, of the second part and of the top, then the end.
  std::vector<int> partStart_;
  std::vector<int> firstPanel_;  // first panel of each supernode
  std::vector<int> top_;         // unknowns of the top; their copies start at size_ + 2
  std::vector<int> row_;         // padded with size_, in the second part with size_ + 1

 private:
  // nameOf: names of the rows. values: start of the entries; returns their end.
  std::size_t addPanels(const SymbolicFactor& symbolic, int s, const std::vector<int>& nameOf, std::size_t values);
};

/// Number of panels of a supernode, and the first column of panel i. Except for the first, each starts with a strip of
/// the front.
inline int panelCount(int columns) { return (columns + PanelLayout::width - 1) / PanelLayout::width; }
inline int panelStart(int columns, int count, int i) {
  const Pivots pivots(columns);
  return std::max(0, 4 * static_cast<int>(static_cast<long long>(pivots.strips) * i / count) - pivots.padding);
}

}  // namespace shapespline
