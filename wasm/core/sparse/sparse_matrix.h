// The symmetric sparse matrix that the solver takes: lower triangle, compressed by columns.
#pragma once

#include <span>
#include <vector>

#include "core/base/compressed_rows.h"
#include "core/base/status.h"

namespace shapespline {

/// One contribution to entry (row, column) of a matrix; contributions to the same entry are added.
struct Triplet {
  int row = 0;
  int column = 0;
  double value = 0.0;
};

/// A symmetric size x size matrix, of which the lower triangle with its diagonal is stored.
/// Column c holds row[i], value[i] for i in [columnStart[c], columnStart[c + 1]), rows strictly ascending
/// and none above the diagonal.
struct SymmetricMatrix {
  int size = 0;
  std::vector<int> columnStart = {0};
  std::vector<int> row;
  std::vector<double> value;
};

/// The matrix that the triplets add up to, in the order in which they are given (so that the sums are reproducible).
/// Every triplet must lie in the lower triangle of a size x size matrix. Every diagonal entry is stored, zero if
/// nothing contributes to it.
SymmetricMatrix assembleSymmetric(int size, std::span<const Triplet> lowerTriplets);

/// Error unless the matrix has the form that SymmetricMatrix promises and every value is finite;
/// error.row is the offending row or column.
Status checkSymmetric(const SymmetricMatrix& matrix);

/// An entry that column p of the factor starts from: matrix.value[source] at row position row >= p.
struct MappedEntry {
  int row, source;
};

/// Where the entries of a matrix go, by column of the factor.
using EntryMap = CompressedRows<MappedEntry>;

EntryMap mapEntries(const SymmetricMatrix& matrix, const std::vector<int>& position);

}  // namespace shapespline
