#include "core/sparse/front_assembly.h"

#include <algorithm>

#include "core/sparse/dense_front.h"

namespace shapespline {

Assembly planAssembly(const SymmetricMatrix& matrix, const SymbolicFactor& symbolic) {
  const EntryMap map = mapEntries(matrix, symbolic.position);
  Assembly assembly;
  assembly.slot.resize(map.item.size());
  assembly.target.resize(map.item.size());
  for (std::size_t i = 0; i < map.item.size(); ++i) assembly.slot[map.item[i].source] = static_cast<int>(i);
  for (int first : symbolic.first) assembly.start.push_back(map.start[first]);

  // Parents come after their children and record the positions of their rows.
  assembly.parentRow.resize(symbolic.row.size());
  const int count = symbolic.supernodes();
  std::vector<int> firstChild(count, -1), sibling(count, -1);
  std::vector<int> local(symbolic.size());  // position -> row in the current front
  for (int s = 0; s < count; ++s) {
    const int first = symbolic.first[s], end = symbolic.first[s + 1];
    const Pivots pivots(end - first);
    for (int p = first; p < end; ++p) local[p] = pivots.padding + p - first;
    for (int r = 0; r < symbolic.rows(s); ++r) local[symbolic.rowsOf(s)[r]] = 4 * pivots.strips + r;
    for (int p = first; p < end; ++p)
      for (int i = map.start[p]; i < map.start[p + 1]; ++i) {
        const int row = local[map.item[i].row];
        assembly.target[i] = pivots.stripAt(row / 4) + 4 * static_cast<std::size_t>(local[p]) + row % 4;
      }
    for (int child = firstChild[s]; child != -1; child = sibling[child])
      for (std::size_t i = symbolic.rowStart[child]; i < symbolic.rowStart[child + 1]; ++i)
        assembly.parentRow[i] = local[symbolic.row[i]];
    if (const int parent = symbolic.parent[s]; parent != -1) {
      sibling[s] = firstChild[parent];
      firstChild[parent] = s;
    }
  }
  return assembly;
}

}  // namespace shapespline
