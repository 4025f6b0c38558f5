// What is drawn of a shape: positions and vertex normals of the raw vertices, so the page never computes any.
#pragma once

#include <array>
#include <cstddef>
#include <vector>

#include "core/base/fork_join.h"
#include "core/base/progress.h"
#include "core/base/types.h"
#include "core/mesh/face_order.h"

namespace shapespline {

/// Area-weighted vertex normals, averaged over groups of raw vertices (weld.h: shadingGroups). Immutable.
class VertexNormals {
 public:
  /// (x, y, z, pad) of each group.
  using Scratch = std::vector<float>;

  /// placeOf: where each raw vertex lies in the shapes that come; neighbours should be near each other there.
  VertexNormals(const std::vector<Triangle>& faces, const std::vector<int>& groupOf, int groups,
                const std::vector<int>& placeOf, const FractionReport& onProgress = {});

  /// places: (x, y, z, pad) at each place. move: what is added to all of them. positions, normals: 3n; normals are
  /// unit, (0, 0, 1) where a vertex has no area around it. To the same bits in one thread or two.
  void draw(const std::vector<float>& places, const Vec3& move, Scratch& scratch, std::vector<float>& positions,
            std::vector<float>& normals, ForkJoin* forkJoin = nullptr) const;

 private:
  struct Drawn {
    int vertex, place, group;
  };
  std::vector<Drawn> drawn_;  // the raw vertices in order of place: read in order and written anywhere is twice as fast
                              // as the other way round
  std::vector<Triangle> corner_;  // faces of places, in their order (face_order.h)
  std::vector<Triangle> target_;  // their corners' groups, numbered in order of place; empty where those are the places
  int groups_;
  std::array<FaceRange, 3> ranges_;
};

}  // namespace shapespline
