#include "core/sparse/sparse_matrix.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <cstddef>
#include <numeric>
#include <string>

namespace shapespline {

namespace {

Error malformed(ErrorCode code, const std::string& what, int index) {
  Error error{code, "The matrix " + what + " at unknown " + std::to_string(index) + "."};
  error.row = index;
  return error;
}

// Stable counting sort of the triplets' indices by ascending key.
template <class Key>
std::vector<int> sortedBy(int size, const std::vector<int>& input, Key key) {
  return compressedRows<int>(size,
                             [&](auto add) {
                               for (int i : input) add(key(i), i);
                             })
      .item;
}

}  // namespace

SymmetricMatrix assembleSymmetric(int size, std::span<const Triplet> lowerTriplets) {
  assert(std::all_of(lowerTriplets.begin(), lowerTriplets.end(),
                     [&](const Triplet& t) { return 0 <= t.column && t.column <= t.row && t.row < size; }));
  std::vector<int> sorted(lowerTriplets.size());
  std::iota(sorted.begin(), sorted.end(), 0);
  sorted = sortedBy(size, sorted, [&](int i) { return lowerTriplets[i].row; });
  sorted = sortedBy(size, sorted, [&](int i) { return lowerTriplets[i].column; });

  SymmetricMatrix matrix;
  matrix.size = size;
  matrix.columnStart.assign(static_cast<std::size_t>(size) + 1, 0);
  std::size_t next = 0;
  for (int column = 0; column < size; ++column) {
    matrix.row.push_back(column);
    matrix.value.push_back(0.0);
    for (; next < sorted.size() && lowerTriplets[sorted[next]].column == column; ++next) {
      const Triplet& triplet = lowerTriplets[sorted[next]];
      if (triplet.row != matrix.row.back()) {
        matrix.row.push_back(triplet.row);
        matrix.value.push_back(0.0);
      }
      matrix.value.back() += triplet.value;
    }
    matrix.columnStart[column + 1] = static_cast<int>(matrix.row.size());
  }
  return matrix;
}

Status checkSymmetric(const SymmetricMatrix& matrix) {
  const auto entries = matrix.row.size();
  if (matrix.size < 0 || matrix.columnStart.size() != static_cast<std::size_t>(matrix.size) + 1 ||
      matrix.columnStart.front() != 0 || static_cast<std::size_t>(matrix.columnStart.back()) != entries ||
      matrix.value.size() != entries) {
    return Error{ErrorCode::Internal,
                 "The lengths of the matrix's arrays do not match its size, or its first column does not start at 0."};
  }
  for (int column = 0; column < matrix.size; ++column) {
    const int begin = matrix.columnStart[column];
    const int end = matrix.columnStart[column + 1];
    if (begin > end || static_cast<std::size_t>(end) > entries)
      return malformed(ErrorCode::Internal, "has invalid column starts", column);
    int previous = column - 1;
    for (int i = begin; i < end; ++i) {
      if (matrix.row[i] <= previous || matrix.row[i] >= matrix.size)
        return malformed(ErrorCode::Internal, "has rows out of order or above the diagonal", column);
      if (!std::isfinite(matrix.value[i]))
        return malformed(ErrorCode::NotFinite, "has a value that is not finite", column);
      previous = matrix.row[i];
    }
  }
  return {};
}

EntryMap mapEntries(const SymmetricMatrix& matrix, const std::vector<int>& position) {
  return compressedRows<MappedEntry>(matrix.size, [&](auto add) {
    for (int column = 0; column < matrix.size; ++column)
      for (int i = matrix.columnStart[column]; i < matrix.columnStart[column + 1]; ++i) {
        const int p = position[column], q = position[matrix.row[i]];
        add(std::min(p, q), {std::max(p, q), i});
      }
  });
}

}  // namespace shapespline
