#include "core/sparse/panel_layout.h"

#include <numeric>

#include "core/sparse/panel_kernels.h"
#include "core/sparse/subtree_partition.h"

namespace shapespline {

std::size_t PanelLayout::lay(const SymbolicFactor& symbolic) {
  size_ = symbolic.size();
  firstPanel_.resize(symbolic.supernodes());
  const std::vector<int> partOf = cutTree(symbolic);
  // Names of each row and of the padding: `own` for the first part and the top, `copied` for the second part.
  std::vector<int> own(size_ + 1), copied;
  std::iota(own.begin(), own.end(), 0);
  copied = own;
  copied[size_] = size_ + 1;
  for (int s = 0; s < symbolic.supernodes(); ++s) {
    if (partOf[s] != topPart) continue;
    for (int p = symbolic.first[s]; p < symbolic.first[s + 1]; ++p) {
      copied[p] = paddedSize();
      top_.push_back(p);
    }
  }
  std::size_t values = 0;
  for (int part : {0, 1, topPart}) {
    partStart_.push_back(static_cast<int>(panels_.size()));
    for (int s = 0; s < symbolic.supernodes(); ++s)
      if (partOf[s] == part) values = addPanels(symbolic, s, part == 1 ? copied : own, values);
  }
  partStart_.push_back(static_cast<int>(panels_.size()));
  return values;
}

std::size_t PanelLayout::addPanels(const SymbolicFactor& symbolic, int s, const std::vector<int>& nameOf,
                                   std::size_t values) {
  firstPanel_[s] = static_cast<int>(panels_.size());
  const int columns = symbolic.columns(s), count = panelCount(columns);
  for (int i = 0; i < count; ++i) {
    const int begin = panelStart(columns, count, i), end = panelStart(columns, count, i + 1);
    Panel panel = {symbolic.first[s] + begin, end - begin, 0, row_.size(), values};
    for (int c = end; c < columns; ++c) row_.push_back(symbolic.first[s] + c);
    for (int r = 0; r < symbolic.rows(s); ++r) row_.push_back(nameOf[symbolic.rowsOf(s)[r]]);
    while ((row_.size() - panel.row) % 4 != 0) row_.push_back(nameOf[size_]);
    panel.rows = static_cast<int>(row_.size() - panel.row);
    values += panelEntries(panel.columns, panel.rows);
    panels_.push_back(panel);
  }
  return values;
}

}  // namespace shapespline
