#include "core/mesh/face_order.h"

#include <algorithm>
#include <cstddef>

namespace shapespline {

FaceHalves halveFaces(const std::vector<Triangle>& corners, int count, int shared, const FractionReport& onProgress) {
  const auto last = [&](std::size_t f) { return *std::max_element(corners[f].begin(), corners[f].end()); };
  std::vector<int> start(static_cast<std::size_t>(count) + 1, 0), sorted(corners.size());
  inBlocks(partOf(onProgress, 0, 0.3), corners.size(), [&](std::size_t begin, std::size_t end) {
    for (std::size_t f = begin; f < end; ++f) ++start[last(f) + 1];
  });
  for (int c = 0; c < count; ++c) start[c + 1] += start[c];
  const auto cut = std::lower_bound(start.begin(), start.end(), static_cast<int>(corners.size() / 2)) - start.begin();
  inBlocks(partOf(onProgress, 0.3, 0.7), corners.size(), [&](std::size_t begin, std::size_t end) {
    for (std::size_t f = begin; f < end; ++f) sorted[start[last(f)]++] = static_cast<int>(f);
  });

  std::vector<int> list[3];  // below the cut, above it, the rest
  inBlocks(partOf(onProgress, 0.7, 1), sorted.size(), [&](std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end; ++i) {
      const Triangle& t = corners[sorted[i]];
      const auto [least, most] = std::minmax_element(t.begin(), t.end());
      const bool rest = std::find(t.begin(), t.end(), shared) != t.end() || (*least < cut && *most >= cut);
      list[rest ? 2 : *most < cut ? 0 : 1].push_back(sorted[i]);
    }
  });
  FaceHalves halves;
  for (int i = 0; i < 3; ++i) {
    if (i < 2) {
      const auto end = list[i].end() - static_cast<std::ptrdiff_t>(list[i].size() % 4);
      list[2].insert(list[2].end(), end, list[i].end());
      list[i].erase(end, list[i].end());
    }
    halves.ranges[i].begin = static_cast<int>(halves.order.size());
    halves.order.insert(halves.order.end(), list[i].begin(), list[i].end());
    halves.ranges[i].end = static_cast<int>(halves.order.size());
  }
  return halves;
}

}  // namespace shapespline
