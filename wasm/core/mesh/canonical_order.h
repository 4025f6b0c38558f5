// Orders vertices and faces by geometry and connectivity, so later results do not depend on the file order.
#pragma once

#include <vector>

#include "core/base/progress.h"
#include "core/base/types.h"
#include "core/mesh/weld.h"

namespace shapespline {

/// A new numbering of a mesh, as maps from new to old numbers.
struct MeshOrder {
  std::vector<int> vertex;  ///< old number of each vertex
  std::vector<int> corner;  ///< for each face: 3 f + c, where corner c of old face f comes first

  std::vector<Triangle> apply(const std::vector<Triangle>& faces) const;
  Positions apply(const Positions& positions) const;
  Welding apply(const Welding& welding) const;
  std::vector<int> oldFaces() const;  ///< old number of each face
};

/// Walks breadth first over edges, from the side that is farthest from the centroid in all poses. Faces start with
/// their entry edge. Vertices are numbered in walking order, unused vertices last, so neighbours have similar numbers.
/// Lengths decide between sides, components, and neighbours at a non-manifold edge. They are invariant to rigid motions
/// of a pose and coarse, so rounding never decides. The file order decides only if the shape is symmetric in every
/// pose. faces: including faces without area; all poses share their vertices. Time: linear, or bounded for symmetric
/// shapes.
MeshOrder canonicalOrder(const std::vector<Triangle>& faces, const std::vector<Positions>& poses,
                         const FractionReport& onProgress = {});

}  // namespace shapespline
