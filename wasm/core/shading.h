// Vertex normals for drawing, beside the positions, so that the page never computes them.
#pragma once

#include <vector>

#include "core/types.h"

namespace shapespline {

/// Area-weighted vertex normals, averaged over groups of raw vertices (weld.h: shadingGroups).
class Shading {
 public:
  Shading() = default;
  Shading(std::vector<int> groupOfVertex, int groups) : group_(std::move(groupOfVertex)), sum_(3 * static_cast<std::size_t>(groups)) {}

  /// positions: 3n. normals: 3n, unit; (0, 0, 1) where a vertex has no area around it.
  void normals(const std::vector<Triangle>& faces, const std::vector<float>& positions, std::vector<float>& normals);

 private:
  std::vector<int> group_;
  std::vector<float> sum_;  // scratch
};

}  // namespace shapespline
