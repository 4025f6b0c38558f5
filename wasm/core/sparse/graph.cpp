#include "core/sparse/graph.h"

#include <utility>

#include "core/base/compressed_rows.h"

namespace shapespline {

Graph graphOf(const SymmetricMatrix& matrix) {
  const auto eachEntryBelow = [&](auto visit) {
    for (int column = 0; column < matrix.size; ++column)
      for (int i = matrix.columnStart[column]; i < matrix.columnStart[column + 1]; ++i)
        if (matrix.row[i] != column) visit(matrix.row[i], column);
  };
  CompressedRows<int> rows = compressedRows<int>(matrix.size, [&](auto add) {
    // Column by column: first each node's smaller neighbours, in order, ...
    eachEntryBelow([&](int row, int column) { add(row, column); });
    // ... then the larger ones, which are the rows of its own column.
    eachEntryBelow([&](int row, int column) { add(column, row); });
  });
  return {std::move(rows.start), std::move(rows.item)};
}

}  // namespace shapespline
