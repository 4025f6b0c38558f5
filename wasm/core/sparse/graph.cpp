#include "core/sparse/graph.h"

#include <cstddef>

namespace shapespline {

Graph graphOf(const SymmetricMatrix& matrix) {
  Graph graph;
  graph.start.assign(static_cast<std::size_t>(matrix.size) + 1, 0);
  const auto forEachEdge = [&](auto visit) {
    for (int column = 0; column < matrix.size; ++column)
      for (int i = matrix.columnStart[column]; i < matrix.columnStart[column + 1]; ++i)
        if (matrix.row[i] != column) visit(matrix.row[i], column);
  };
  forEachEdge([&](int a, int b) { ++graph.start[a + 1], ++graph.start[b + 1]; });
  for (int v = 0; v < matrix.size; ++v) graph.start[v + 1] += graph.start[v];

  graph.neighbour.resize(graph.start.back());
  std::vector<int> next(graph.start.begin(), graph.start.end() - 1);
  // Column by column: first every node's smaller neighbours arrive in order, ...
  forEachEdge([&](int row, int column) { graph.neighbour[next[row]++] = column; });
  // ... then its larger ones, which are the rows of its own column.
  forEachEdge([&](int row, int column) { graph.neighbour[next[column]++] = row; });
  return graph;
}

}  // namespace shapespline
