// Orders vertices and faces by geometry and connectivity, so later results do not depend on the file order.
#pragma once

#include <vector>

#include "core/base/progress.h"
#include "core/base/types.h"
#include "core/mesh/weld.h"

namespace shapespline {

/// A new numbering of a mesh, as maps from new to old numbers.
struct MeshOrder {
  std::vector<int> vertex;  ///< of each vertex
  std::vector<int> corner;  ///< of each face 3 f + c: face f, whose corner c comes first now
  bool mirrored = false;    ///< every face runs the other way round

  std::vector<Triangle> apply(const std::vector<Triangle>& faces) const;
  Positions apply(const Positions& positions) const;
  Welding apply(const Welding& welding) const;
  std::vector<int> oldFaces() const;  ///< old number of each face
};

/// Breadth first from face to face over their edges, from the side of a face that lies farthest out in all poses. Faces
/// that are entered over an edge start with it; vertices are numbered as they are met, those in no face last.
/// Neighbours are therefore near each other. Which side comes first, which component, and which neighbour at a
/// non-manifold edge, is decided by lengths that a rigid motion of a pose keeps, so coarsely that rounding decides
/// nothing; so is the way round in which sides follow each other. By the file's order only where the shape is symmetric
/// in every pose. faces: of vertices that every pose has; those without area count, too. Time: linear but for symmetric
/// shapes, where it is bounded.
MeshOrder canonicalOrder(const std::vector<Triangle>& faces, const std::vector<Positions>& poses,
                         const FractionReport& onProgress = {});

}  // namespace shapespline
