// The symmetric sparse matrix for the solver: lower triangle, compressed by columns.
#pragma once

#include <span>
#include <vector>

#include "core/base/compressed_rows.h"
#include "core/base/status.h"

namespace shapespline {

/// One contribution to entry (row, column) of a matrix. Contributions to the same entry are added.
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

/// Adds up the triplets in the given order, so the sums are reproducible. Every triplet must be in the lower triangle
/// of a size x size matrix. Every diagonal entry is stored, even if it is zero.
SymmetricMatrix assembleSymmetric(int size, std::span<const Triplet> lowerTriplets);

/// Error unless the matrix meets the conditions of SymmetricMatrix and every value is finite.
/// error.row is the offending row or column.
Status checkSymmetric(const SymmetricMatrix& matrix);

/// Source of an entry in column p of the factor: matrix.value[source] at row position row >= p.
struct MappedEntry {
  int row, source;
};

/// The entries of a matrix by column of the factor.
using EntryMap = CompressedRows<MappedEntry>;

EntryMap mapEntries(const SymmetricMatrix& matrix, const std::vector<int>& position);

}  // namespace shapespline
