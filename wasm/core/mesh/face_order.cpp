#include "core/mesh/face_order.h"

#include <algorithm>
#include <cstddef>

#include "core/base/compressed_rows.h"

namespace shapespline {

FaceOrder orderFaces(const std::vector<Triangle>& corners, int count, int shared, const FractionReport& onProgress) {
  const auto byLast = [&](std::size_t f, auto add) {
    add(*std::max_element(corners[f].begin(), corners[f].end()), static_cast<int>(f));
  };
  const CompressedRows<int> rows = compressedRows<int>(count, corners.size(), byLast, partOf(onProgress, 0, 0.7));
  const std::vector<int>&start = rows.start, &sorted = rows.item;
  const auto cut = std::lower_bound(start.begin(), start.end(), static_cast<int>(corners.size() / 2)) - start.begin();

  std::vector<int> list[3];  // below the cut, above the cut, crossing
  inBlocks(partOf(onProgress, 0.7, 1), sorted.size(), [&](std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end; ++i) {
      const Triangle& t = corners[sorted[i]];
      const auto [least, most] = std::minmax_element(t.begin(), t.end());
      const bool rest = std::find(t.begin(), t.end(), shared) != t.end() || (*least < cut && *most >= cut);
      list[rest ? 2 : *most < cut ? 0 : 1].push_back(sorted[i]);
    }
  });
  FaceOrder ordered;
  for (int i = 0; i < 3; ++i) {
    if (i < 2) {
      const auto end = list[i].end() - static_cast<std::ptrdiff_t>(list[i].size() % 4);
      list[2].insert(list[2].end(), end, list[i].end());
      list[i].erase(end, list[i].end());
    }
    ordered.ranges[i].begin = static_cast<int>(ordered.order.size());
    ordered.order.insert(ordered.order.end(), list[i].begin(), list[i].end());
    ordered.ranges[i].end = static_cast<int>(ordered.order.size());
  }
  return ordered;
}

}  // namespace shapespline
