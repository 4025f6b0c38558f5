#include "core/sparse/elimination_tree.h"

#include <algorithm>
#include <cassert>
#include <cstddef>

namespace shapespline {

Graph permuted(const Graph& graph, const std::vector<int>& order, const FractionReport& onProgress) {
  const int size = graph.size();
  std::vector<int> position(size);
  for (int p = 0; p < size; ++p) position[order[p]] = p;

  Graph result;
  result.start.assign(static_cast<std::size_t>(size) + 1, 0);
  result.neighbour.resize(graph.neighbour.size());
  for (int p = 0; p < size; ++p) result.start[p + 1] = result.start[p] + graph.degree(order[p]);
  // The ascending order sorts all neighbour lists.
  std::vector<int> next(result.start.begin(), result.start.end() - 1);
  inBlocks(onProgress, order.size(), [&](std::size_t from, std::size_t end) {
    for (std::size_t p = from; p < end; ++p)
      for (int u : graph.neighbours(order[p])) result.neighbour[next[position[u]]++] = static_cast<int>(p);
  });
  return result;
}

std::vector<int> eliminationTree(const Graph& graph, const FractionReport& onProgress) {
  const int size = graph.size();
  std::vector<int> parent(size, -1);
  std::vector<int> ancestor(size, -1);  // path-compressed towards the root of the current tree
  inBlocks(onProgress, static_cast<std::size_t>(size), [&](std::size_t begin, std::size_t end) {
    for (int j = static_cast<int>(begin); j < static_cast<int>(end); ++j)
      for (int i : graph.neighbours(j))
        while (i != -1 && i < j) {
          const int next = ancestor[i];
          ancestor[i] = j;
          if (next == -1) parent[i] = j;
          i = next;
        }
  });
  return parent;
}

std::vector<int> postorder(const std::vector<int>& parent) {
  const int size = static_cast<int>(parent.size());
  std::vector<int> firstChild(size, -1), sibling(size, -1), order, stack;
  for (int v = size - 1; v >= 0; --v) {  // descending, so the lists ascend
    if (parent[v] == -1) continue;
    sibling[v] = firstChild[parent[v]];
    firstChild[parent[v]] = v;
  }
  order.reserve(size);
  for (int root = 0; root < size; ++root) {
    if (parent[root] != -1) continue;
    stack.push_back(root);
    while (!stack.empty()) {
      const int v = stack.back();
      const int child = firstChild[v];
      if (child == -1) {
        order.push_back(v);
        stack.pop_back();
      } else {
        firstChild[v] = sibling[child];
        stack.push_back(child);
      }
    }
  }
  return order;
}

namespace {

// The root of i's set, with path compression.
int findRoot(std::vector<int>& set, int i) {
  int root = i;
  while (set[root] != root) root = set[root];
  while (set[i] != root) {
    const int next = set[i];
    set[i] = root;
    i = next;
  }
  return root;
}

}  // namespace

std::vector<int> factorColumnCounts(const Graph& graph, const std::vector<int>& parent,
                                    const FractionReport& onProgress) {
  assert(std::ranges::is_sorted(postorder(parent)));
  const int size = graph.size();
  // Row i of the factor is a subtree rooted at i. A column's count is the number of row subtrees that contain it. Each
  // row subtree adds one at its leaves and subtracts one where two branches meet.
  std::vector<int> count(size, 0), first(size, -1), previousLeaf(size, -1), maxFirst(size, -1), set(size);
  for (int j = 0; j < size; ++j) {
    set[j] = j;
    count[j] = first[j] == -1 ? 1 : 0;  // a leaf of the elimination tree starts its own row subtree
    for (int i = j; i != -1 && first[i] == -1; i = parent[i]) first[i] = j;
  }
  inBlocks(onProgress, static_cast<std::size_t>(size), [&](std::size_t begin, std::size_t end) {
    for (int j = static_cast<int>(begin); j < static_cast<int>(end); ++j) {
      if (parent[j] != -1) --count[parent[j]];
      for (int i : graph.neighbours(j)) {
        if (i <= j || first[j] <= maxFirst[i]) continue;  // j is not a leaf of row i's subtree
        maxFirst[i] = first[j];
        ++count[j];
        if (previousLeaf[i] != -1) --count[findRoot(set, previousLeaf[i])];
        previousLeaf[i] = j;
      }
      if (parent[j] != -1) set[j] = parent[j];
    }
  });
  for (int j = 0; j < size; ++j)
    if (parent[j] != -1) count[parent[j]] += count[j];
  return count;
}

}  // namespace shapespline
