// Positions and vertex normals of the raw vertices for drawing. The page never computes normals.
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

  /// slotOf: slot of each raw vertex in the shapes. Neighbours should have close slots.
  VertexNormals(const std::vector<Triangle>& faces, const std::vector<int>& groupOf, int groups,
                const std::vector<int>& slotOf, const FractionReport& onProgress = {});

  /// xyzp: (x, y, z, pad) per slot. move: added to all positions. positions, normals: 3n. Normals are unit vectors, or
  /// (0, 0, 1) at a vertex without area. One or two threads give the same bits.
  void draw(const std::vector<float>& xyzp, const Vec3& move, Scratch& scratch, std::vector<float>& positions,
            std::vector<float>& normals, ForkJoin* forkJoin = nullptr) const;

 private:
  struct Drawn {
    int vertex, slot, group;
  };
  // raw vertices in slot order: sequential reads with random writes are twice as fast as the reverse
  std::vector<Drawn> drawn_;
  std::vector<Triangle> corner_;  // corner slots of the faces, ordered by face_order.h
  std::vector<Triangle> target_;  // groups of these corners, numbered in slot order; empty if equal to the slots
  int groups_;
  std::array<FaceRange, 3> ranges_;
};

}  // namespace shapespline
