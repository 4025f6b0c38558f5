#include "core/sparse/symbolic.h"

#include <algorithm>
#include <cassert>
#include <cstddef>
#include <numeric>

#include "core/base/permutation.h"
#include "core/base/sort_indices.h"
#include "core/sparse/elimination_tree.h"

namespace shapespline {

namespace {

// Merging a child into its parent stores zeros but saves the child's rows in every gather, scatter and assembly.
// The costs of one row and of one supernode, in units of one stored entry. Measured on mesh Laplacians.
constexpr std::int64_t costOfRow = 4;
constexpr std::int64_t costOfSupernode = 80;

// One node of the supernode tree during merging.
struct Node {
  int columns = 0;
  int front = 0;  // number of columns and rows below
  int parent = -1;
};

std::int64_t trapezoid(std::int64_t columns, std::int64_t front) {
  return columns * front - columns * (columns - 1) / 2;
}

// Maximal runs of columns with the same structure; supernodeOf[j] is the run of column j.
std::vector<Node> maximalSupernodes(const std::vector<int>& parent, const std::vector<int>& count,
                                    std::vector<int>& supernodeOf) {
  const int size = static_cast<int>(parent.size());
  std::vector<Node> nodes;
  supernodeOf.resize(size);
  for (int j = 0; j < size; ++j) {
    if (j == 0 || parent[j - 1] != j || count[j - 1] != count[j] + 1) nodes.push_back({0, count[j], -1});
    ++nodes.back().columns;
    supernodeOf[j] = static_cast<int>(nodes.size()) - 1;
  }
  for (int j = 0; j < size; ++j) {
    Node& node = nodes[supernodeOf[j]];
    if (parent[j] != -1 && supernodeOf[parent[j]] != supernodeOf[j]) node.parent = supernodeOf[parent[j]];
  }
  return nodes;
}

// Merges children into parents while this reduces the cost. mergedInto[s] is s itself for remaining nodes.
std::vector<int> mergeSupernodes(std::vector<Node>& nodes) {
  const int count = static_cast<int>(nodes.size());
  std::vector<int> mergedInto(count), firstChild(count, -1), sibling(count, -1), children;
  std::iota(mergedInto.begin(), mergedInto.end(), 0);
  for (int s = 0; s < count; ++s) {
    Node& parent = nodes[s];
    children.clear();
    for (int c = firstChild[s]; c != -1; c = sibling[c]) children.push_back(c);
    // Merges children with the most rows first, because they share the most with the parent.
    sortIndices(children, [&](int a, int b) {
      const int rowsA = nodes[a].front - nodes[a].columns, rowsB = nodes[b].front - nodes[b].columns;
      return rowsA != rowsB ? rowsA > rowsB : a < b;
    });
    for (int c : children) {
      const Node& child = nodes[c];
      const std::int64_t zeros = trapezoid(parent.columns + child.columns, parent.front + child.columns) -
                                 trapezoid(parent.columns, parent.front) - trapezoid(child.columns, child.front);
      if (zeros > costOfRow * (child.front - child.columns) + costOfSupernode) continue;
      parent.columns += child.columns;
      parent.front += child.columns;
      mergedInto[c] = s;
    }
    if (parent.parent != -1) {
      sibling[s] = firstChild[parent.parent];
      firstChild[parent.parent] = s;
    }
  }
  for (int s = count - 1; s >= 0; --s) mergedInto[s] = mergedInto[mergedInto[s]];
  for (Node& node : nodes)
    if (node.parent != -1) node.parent = mergedInto[node.parent];
  return mergedInto;
}

// Approximate number of doubles in the lower triangle of a front.
std::int64_t lowerTriangle(std::int64_t n) { return n * (n + 1) / 2; }

// Postorder of the merged tree, with every node's children in descending order of (peak - update) memory.
std::vector<int> stackOrder(const std::vector<Node>& nodes, const std::vector<int>& mergedInto) {
  const int count = static_cast<int>(nodes.size());
  std::vector<std::vector<int>> children(count);
  std::vector<std::int64_t> peak(count, 0);
  std::vector<int> roots;
  const auto update = [&](int s) { return lowerTriangle(nodes[s].front - nodes[s].columns); };
  for (int s = 0; s < count; ++s) {
    if (mergedInto[s] != s) continue;
    sortIndices(children[s], [&](int a, int b) {
      const std::int64_t keyA = peak[a] - update(a), keyB = peak[b] - update(b);
      return keyA != keyB ? keyA > keyB : a < b;
    });
    std::int64_t held = 0;
    for (int c : children[s]) {
      peak[s] = std::max(peak[s], held + peak[c]);
      held += update(c);
    }
    peak[s] = std::max(peak[s], held + lowerTriangle(nodes[s].front));
    if (nodes[s].parent == -1) roots.push_back(s);
    else children[nodes[s].parent].push_back(s);
  }

  std::vector<int> result, stack;
  std::vector<std::size_t> next(count, 0);
  for (int root : roots) {
    stack.push_back(root);
    while (!stack.empty()) {
      const int s = stack.back();
      if (next[s] < children[s].size()) {
        stack.push_back(children[s][next[s]++]);
      } else {
        result.push_back(s);
        stack.pop_back();
      }
    }
  }
  return result;
}

// Sets the rows of every supernode: the rows of its columns' entries and of its children, beyond its own columns.
void collectRows(const Graph& graph, SymbolicFactor& factor, const FractionReport& onProgress) {
  const int count = factor.supernodes();
  std::vector<int> firstChild(count, -1), sibling(count, -1), mark(factor.size(), -1);
  factor.rowStart.assign(1, 0);
  for (int s = 0; s < count; ++s) {
    reportItem(onProgress, static_cast<std::size_t>(s), static_cast<std::size_t>(count));
    const int end = factor.first[s + 1];
    const auto add = [&](int p) {
      if (p < end || mark[p] == s) return;
      mark[p] = s;
      factor.row.push_back(p);
    };
    for (int p = factor.first[s]; p < end; ++p)
      for (int u : graph.neighbours(factor.order[p])) add(factor.position[u]);
    for (int c = firstChild[s]; c != -1; c = sibling[c])
      for (std::size_t i = factor.rowStart[c]; i < factor.rowStart[c + 1]; ++i) add(factor.row[i]);
    std::sort(factor.row.begin() + static_cast<std::ptrdiff_t>(factor.rowStart[s]), factor.row.end());
    factor.rowStart.push_back(factor.row.size());
    if (const int parent = factor.parent[s]; parent != -1) {
      sibling[s] = firstChild[parent];
      firstChild[parent] = s;
    }
  }
}

}  // namespace

SymbolicFactor analyseFactor(const Graph& graph, const std::vector<int>& order, const FractionReport& onProgress) {
  assert(isPermutation(order));
  const int size = graph.size();
  // Renumbers by a postorder of the elimination tree.
  const std::vector<int> parent =
      eliminationTree(permuted(graph, order, partOf(onProgress, 0, 0.15)), partOf(onProgress, 0.15, 0.2));
  const std::vector<int> post = postorder(parent);
  std::vector<int> postordered(size), inverse(size), postParent(size);
  for (int p = 0; p < size; ++p) {
    inverse[post[p]] = p;
    postordered[p] = order[post[p]];
  }
  for (int p = 0; p < size; ++p) postParent[p] = parent[post[p]] == -1 ? -1 : inverse[parent[post[p]]];

  std::vector<int> supernodeOf;
  const std::vector<int> counts = factorColumnCounts(permuted(graph, postordered, partOf(onProgress, 0.25, 0.4)),
                                                     postParent, partOf(onProgress, 0.4, 0.5));
  std::vector<Node> nodes = maximalSupernodes(postParent, counts, supernodeOf);
  reportFraction(onProgress, 0.55);
  const std::vector<int> mergedInto = mergeSupernodes(nodes);
  const std::vector<int> finalOrder = stackOrder(nodes, mergedInto);

  reportFraction(onProgress, 0.7);
  // Places columns of merged supernodes together, the child's before the parent's.
  SymbolicFactor factor;
  std::vector<int> finalIndex(nodes.size(), -1);
  for (std::size_t i = 0; i < finalOrder.size(); ++i) {
    finalIndex[finalOrder[i]] = static_cast<int>(i);
    factor.first.push_back(factor.first.back() + nodes[finalOrder[i]].columns);
  }
  for (int s : finalOrder) factor.parent.push_back(nodes[s].parent == -1 ? -1 : finalIndex[nodes[s].parent]);
  std::vector<int> next(factor.first.begin(), factor.first.end() - 1);
  factor.order.resize(size);
  factor.position.resize(size);
  for (int p = 0; p < size; ++p) {
    const int at = next[finalIndex[mergedInto[supernodeOf[p]]]]++;
    factor.order[at] = postordered[p];
    factor.position[postordered[p]] = at;
  }
  collectRows(graph, factor, partOf(onProgress, 0.7, 1));
  return factor;
}

}  // namespace shapespline
