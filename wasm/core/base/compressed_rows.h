// Items by row in one array (CSR), built by a counting sort.
#pragma once

#include <cassert>
#include <cstddef>
#include <numeric>
#include <span>
#include <utility>
#include <vector>

#include "core/base/progress.h"

namespace shapespline {

/// The items of row r are item[start[r]] to item[start[r + 1] - 1].
template <class Item>
struct CompressedRows {
  std::vector<int> start = {0};
  std::vector<Item> item;

  int count() const { return static_cast<int>(start.size()) - 1; }
  std::span<Item> of(int row) { return {item.data() + start[row], item.data() + start[row + 1]}; }
  std::span<const Item> of(int row) const { return {item.data() + start[row], item.data() + start[row + 1]}; }
};

/// Builds rows from items in any order: counts all of them, then places all of them. Items in a row keep their
/// placement order.
template <class Item>
class RowSorter {
 public:
  explicit RowSorter(int rowCount) { rows_.start.assign(static_cast<std::size_t>(rowCount) + 1, 0); }

  void count(int row) { ++rows_.start[row + 1]; }

  /// Allocates the rows after counting.
  void allocate() {
    std::partial_sum(rows_.start.begin(), rows_.start.end(), rows_.start.begin());
    rows_.item.resize(rows_.start.back());
    next_.assign(rows_.start.begin(), rows_.start.end() - 1);
  }

  void place(int row, const Item& item) {
    assert(next_[row] < rows_.start[row + 1]);
    rows_.item[next_[row]++] = item;
  }

  /// Returns the rows after placement.
  CompressedRows<Item> take() { return std::move(rows_); }

 private:
  CompressedRows<Item> rows_;
  std::vector<int> next_;  // position of the next item in each row
};

/// each(add) calls add(row, item) for every item. It is called twice and must make the same calls both times.
template <class Item, class Each>
CompressedRows<Item> compressedRows(int rowCount, Each each) {
  RowSorter<Item> sorter(rowCount);
  each([&](int row, const Item&) { sorter.count(row); });
  sorter.allocate();
  each([&](int row, const Item& item) { sorter.place(row, item); });
  return sorter.take();
}

/// each(i, add) calls add(row, item) for the items of number i, for n numbers in blocks (progress.h). It is called
/// twice per number and must make the same calls both times.
template <class Item, class Each>
CompressedRows<Item> compressedRows(int rowCount, std::size_t n, Each each, const FractionReport& onProgress) {
  RowSorter<Item> sorter(rowCount);
  inBlocks(partOf(onProgress, 0, 0.4), n, [&](std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end; ++i) each(i, [&](int row, const Item&) { sorter.count(row); });
  });
  sorter.allocate();
  inBlocks(partOf(onProgress, 0.4, 1), n, [&](std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end; ++i) each(i, [&](int row, const Item& item) { sorter.place(row, item); });
  });
  return sorter.take();
}

}  // namespace shapespline
