#include "core/sparse/subtree_partition.h"

#include <algorithm>
#include <cstdint>
#include <numeric>

namespace shapespline {

// In a postorder, all supernodes before a split form whole subtrees. Supernodes after the split with a descendant
// before it form the top; the other supernodes form whole subtrees. A single split thus defines the cut. The chosen
// split lets both threads finish earliest.
std::vector<int> cutTree(const SymbolicFactor& symbolic) {
  const int count = symbolic.supernodes();
  std::vector<int> firstDescendant(count);
  std::iota(firstDescendant.begin(), firstDescendant.end(), 0);
  std::vector<std::int64_t> work(count),
      above(static_cast<std::size_t>(count) + 1, 0);  // change of the work above at each split
  std::int64_t total = 0;
  for (int s = 0; s < count; ++s) {
    const std::int64_t columns = symbolic.columns(s), rows = symbolic.rows(s);
    work[s] = columns * (columns + 1) / 2 + columns * rows;
    total += work[s];
    above[firstDescendant[s] + 1] += work[s];  // cancels for leaves
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
    if (longest < least) {
      least = longest;
      split = s + 1;
    }
  }
  std::vector<int> part(count);
  for (int s = 0; s < count; ++s) part[s] = s < split ? 0 : firstDescendant[s] < split ? topPart : 1;
  return part;
}

}  // namespace shapespline
