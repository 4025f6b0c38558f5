// How a factor's supernodes are cut into panels, and for two to work on.
#pragma once

#include <algorithm>
#include <cstddef>
#include <vector>

#include "core/sparse/dense_front.h"
#include "core/sparse/symbolic.h"

namespace shapespline {

/// A supernode's columns are cut into panels of at most width, all of about the same width.
///
/// The supernode tree is cut into two parts, one per thread, and a top (subtree_partition.h); panels are stored in that
/// order. The second part must not touch the unknowns of the top: its rows index copies of them, beyond the matrix's
/// size.
class PanelLayout {
 public:
  static constexpr int width = 64;

  /// Unknowns: the matrix's, one that fills up each part's rows, the copies.
  int paddedSize() const { return size_ + 2 + static_cast<int>(top_.size()); }
  std::size_t indexBytes() const { return row_.size() * sizeof(int) + panels_.size() * sizeof(Panel); }

 protected:
  struct Panel {
    int first;  // column
    int columns;
    int rows;            // below its triangle, a multiple of four
    std::size_t row;     // where they start in row_
    std::size_t values;  // where its entries start
  };

  // Returns how many entries there are.
  std::size_t lay(const SymbolicFactor& symbolic);

  int size_ = 0;
  std::vector<Panel> panels_;
  std::vector<int> partStart_;   // of both parts and the top in panels_, and its end
  std::vector<int> firstPanel_;  // of each supernode
  std::vector<int> top_;         // unknowns of the top; their copies lie from size_ + 2 on
  std::vector<int> row_;         // filled up with size_, in the second part with size_ + 1

 private:
  // nameOf: what rows are called. values: where its entries start; returns where they end.
  std::size_t addPanels(const SymbolicFactor& symbolic, int s, const std::vector<int>& nameOf, std::size_t values);
};

/// Panels of a supernode, and the first column of panel i: each but the first starts with a strip of the front.
inline int panelCount(int columns) { return (columns + PanelLayout::width - 1) / PanelLayout::width; }
inline int panelStart(int columns, int count, int i) {
  const Pivots pivots(columns);
  return std::max(0, 4 * static_cast<int>(static_cast<long long>(pivots.strips) * i / count) - pivots.padding);
}

}  // namespace shapespline
