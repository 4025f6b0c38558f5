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
  std::vector<int> corner;  ///< one per face: 3 f + c for old face f, whose corner c is now the first
  bool mirrored = false;    ///< the winding of every face is reversed

  std::vector<Triangle> apply(const std::vector<Triangle>& faces) const;
  Positions apply(const Positions& positions) const;
  Welding apply(const Welding& welding) const;
  std::vector<int> oldFaces() const;  ///< old number of each face
};

/// Visits faces breadth first across their edges, starting with the side of a face that is farthest out in all poses.
/// The first side of each face is the one across which it was visited. Numbers vertices when they are first visited,
/// and vertices without a face last, so neighbours have close numbers. Lengths that a rigid motion preserves choose the
/// first side, the next component, the neighbour at a non-manifold edge and the direction around a face. They are
/// rounded coarsely, so rounding errors decide nothing. The file's order decides only in shapes that are symmetric in
/// every pose. faces: indices of the poses' vertices; may include faces without area. Time: linear, with a bounded
/// addition for symmetric shapes.
MeshOrder canonicalOrder(const std::vector<Triangle>& faces, const std::vector<Positions>& poses,
                         const FractionReport& onProgress = {});

}  // namespace shapespline
