// Minimum vertex covers of bipartite graphs.
#pragma once

#include <vector>

namespace shapespline {

/// Left node v's neighbours on the right are neighbour[start[v]] ... neighbour[start[v + 1] - 1].
struct BipartiteGraph {
  std::vector<int> start;
  std::vector<int> neighbour;
  int rightSize = 0;

  int leftSize() const { return static_cast<int>(start.size()) - 1; }
};

struct VertexCover {
  std::vector<int> left, right;
};

/// A smallest set of nodes that touches every edge, by a maximum matching (Hopcroft and Karp 1973) and König's theorem.
VertexCover minimumVertexCover(const BipartiteGraph& graph);

}  // namespace shapespline
