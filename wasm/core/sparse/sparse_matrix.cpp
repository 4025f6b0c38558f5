#include "core/sparse/sparse_matrix.h"

#include <cmath>
#include <cstddef>
#include <string>

namespace shapespline {

namespace {

Error malformed(ErrorCode code, const std::string& what, int index) {
  Error error{code, "The matrix " + what + " at unknown " + std::to_string(index) + "."};
  error.vertex = index;
  return error;
}

// Stable counting sort of the triplets' indices: result lists them by ascending key.
template <class Key>
std::vector<int> sortedBy(int size, const std::vector<int>& input, Key key) {
  std::vector<int> start(static_cast<std::size_t>(size) + 1, 0);
  for (int i : input) ++start[key(i) + 1];
  for (int c = 0; c < size; ++c) start[c + 1] += start[c];
  std::vector<int> output(input.size());
  for (int i : input) output[start[key(i)]++] = i;
  return output;
}

}  // namespace

SymmetricMatrix assembleSymmetric(int size, std::span<const Triplet> lowerTriplets) {
  std::vector<int> sorted(lowerTriplets.size());
  for (std::size_t i = 0; i < sorted.size(); ++i) sorted[i] = static_cast<int>(i);
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
    return Error{ErrorCode::Internal, "The matrix is not square or its arrays disagree in length."};
  }
  for (int column = 0; column < matrix.size; ++column) {
    const int begin = matrix.columnStart[column];
    const int end = matrix.columnStart[column + 1];
    if (begin > end || static_cast<std::size_t>(end) > entries)
      return malformed(ErrorCode::Internal, "has broken column starts", column);
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
  EntryMap map;
  map.start.assign(static_cast<std::size_t>(matrix.size) + 1, 0);
  const auto forEachEntry = [&](auto visit) {
    for (int column = 0; column < matrix.size; ++column)
      for (int i = matrix.columnStart[column]; i < matrix.columnStart[column + 1]; ++i) {
        const int p = position[column], q = position[matrix.row[i]];
        visit(std::min(p, q), std::max(p, q), i);
      }
  };
  forEachEntry([&](int p, int, int) { ++map.start[p + 1]; });
  for (int p = 0; p < matrix.size; ++p) map.start[p + 1] += map.start[p];
  map.row.resize(matrix.row.size());
  map.source.resize(matrix.row.size());
  std::vector<int> next(map.start.begin(), map.start.end() - 1);
  forEachEntry([&](int p, int q, int i) {
    map.row[next[p]] = q;
    map.source[next[p]++] = i;
  });
  return map;
}

}  // namespace shapespline
