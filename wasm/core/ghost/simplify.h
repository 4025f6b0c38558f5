// The ghost mesh: a coarse mesh in all poses at once, by edge collapses (paper section 4.3; Garland and Heckbert 1997).
#pragma once

#include <vector>

#include "core/base/progress.h"
#include "core/base/types.h"
#include "core/lri/welded_shape.h"

namespace shapespline {

struct SimplifyOptions {
  int targetFaces = 2000;
  /// Each pose's vertices move to where the error is least; else they stay vertices of the shape.
  bool optimalPlacement = false;
};

/// A coarse mesh with the shape's poses.
struct GhostMesh {
  std::vector<Triangle> faces;   ///< of ghost vertices
  std::vector<Positions> poses;  ///< one per column of the shape
  /// Of each ghost vertex: the shape's vertex at (or, moved, nearest) it among those it stands for.
  std::vector<int> vertexOf;
  /// Of each vertex of the shape: the ghost vertex that it collapsed to; -1 where it has none.
  std::vector<int> ghostOf;
  int joinedComponents = 0;  ///< components too small for a share: they have no ghost of their own
};

/// One collapse sequence for all poses. The cost of a collapse is the sum of its quadric errors over the poses; a
/// collapse is legal if it keeps the topology (collapse_mesh.h) and, in every pose, turns no face over and leaves none
/// too thin. Components keep at least half of their share of the faces, and four; where the target is too small for
/// that, the smallest join their neighbours.
///
/// Deterministic. A rigid motion of a pose changes nothing: costs are compared to three digits, and ties fall to the
/// vertex. The result may have more faces than asked for where no legal collapse is left. Time: O(m log m) for bounded
/// valence. onProgress: fraction in [0, 1], called a few thousand steps apart.
GhostMesh simplify(const WeldedShape& shape, const ShapeTopology& topology, const SimplifyOptions& options,
                   const FractionReport& onProgress);

}  // namespace shapespline
