#include "core/sparse/subtree_partition.h"

#include <algorithm>
#include <cstdint>
#include <numeric>

namespace shapespline {

// In a postorder all supernodes before a split are whole subtrees. Of those from there on, the ones with a descendant
// before the split lie above; the others are whole subtrees again. So one split decides the cut: the one after which
// both are done first.
std::vector<int> cutTree(const SymbolicFactor& symbolic) {
  const int count = symbolic.supernodes();
  std::vector<int> firstDescendant(count);
  std::iota(firstDescendant.begin(), firstDescendant.end(), 0);
  std::vector<std::int64_t> work(count),
      above(static_cast<std::size_t>(count) + 1, 0);  // above: by how much it changes at each split
  std::int64_t total = 0;
  for (int s = 0; s < count; ++s) {
    const std::int64_t columns = symbolic.columns(s), rows = symbolic.rows(s);
    work[s] = columns * (columns + 1) / 2 + columns * rows;
    total += work[s];
    above[firstDescendant[s] + 1] += work[s];  // cancels out in a leaf
    above[s + 1] -= work[s];
    if (const int parent = symbolic.parent[s]; parent != -1)
      firstDescendant[parent] = std::min(firstDescendant[parent], firstDescendant[s]);
  }
  int split = 0;
  std::int64_t least = total, before = 0, top = 0;
  for (int s = 0; s < count; ++s) {
    before += work[s];
    top += above[s + 1];
    const std::int64_t longest = std::max(before, total - before - top) + top;
    if (longest < least) least = longest, split = s + 1;
  }
  std::vector<int> part(count);
  for (int s = 0; s < count; ++s) part[s] = s < split ? 0 : firstDescendant[s] < split ? topPart : 1;
  return part;
}

}  // namespace shapespline
