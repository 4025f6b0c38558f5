// Vertex normals for drawing, beside the positions, so that the page never computes them.
#pragma once

#include <vector>

#include "core/types.h"

namespace shapespline {

/// Area-weighted vertex normals, averaged over groups of raw vertices (weld.h: shadingGroups).
class Shading {
 public:
  Shading() = default;

  /// rank: a number for each raw vertex that is about equal for neighbours; the work is done in its order.
  Shading(const std::vector<Triangle>& faces, const std::vector<int>& groupOfVertex, int groups, const std::vector<int>& rank);

  /// positions: 3n. normals: 3n, unit; (0, 0, 1) where a vertex has no area around it.
  void normals(const std::vector<float>& positions, std::vector<float>& normals);

 private:
  std::vector<int> vertexAt_;     // raw vertices in order of rank
  std::vector<Triangle> corner_;  // faces of places in that order, themselves in order of rank
  std::vector<Triangle> target_;  // their corners' groups; empty where every vertex is a group of its own, in the same order
  std::vector<int> group_;        // of each raw vertex, numbered in order of rank
  std::vector<float> place_, sum_;  // scratch: (x, y, z, pad) of each vertex and group
};

}  // namespace shapespline
