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

  /// slotOf: where each raw vertex lies in the shapes that come; neighbours should be near each other there.
  VertexNormals(const std::vector<Triangle>& faces, const std::vector<int>& groupOf, int groups,
                const std::vector<int>& slotOf, const FractionReport& onProgress = {});

  /// xyzp: (x, y, z, pad) at each slot. move: what is added to all of them. positions, normals: 3n; normals are
  /// unit, (0, 0, 1) where a vertex has no area around it. To the same bits in one thread or two.
  void draw(const std::vector<float>& xyzp, const Vec3& move, Scratch& scratch, std::vector<float>& positions,
            std::vector<float>& normals, ForkJoin* forkJoin = nullptr) const;

 private:
  struct Drawn {
    int vertex, slot, group;
  };
  std::vector<Drawn> drawn_;  // the raw vertices in order of slot: read in order and written anywhere is twice as fast
                              // as the other way round
  std::vector<Triangle> corner_;  // faces by slot, in their order (face_order.h)
  std::vector<Triangle> target_;  // their corners' groups, numbered in order of slot; empty where those are the slots
  int groups_;
  std::array<FaceRange, 3> ranges_;
};

}  // namespace shapespline
