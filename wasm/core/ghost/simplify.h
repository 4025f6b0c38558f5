// The ghost mesh: a coarse mesh for all poses, made by edge collapses (paper section 4.3; Garland and Heckbert 1997).
#pragma once

#include <vector>

#include "core/base/progress.h"
#include "core/base/types.h"
#include "core/lri/welded_shape.h"

namespace shapespline {

struct SimplifyOptions {
  int targetFaces = 2000;
  /// Places each pose's vertices at the minimum of the error. Otherwise they stay vertices of the shape.
  bool optimalPlacement = false;
};

/// A coarse mesh with the shape's poses.
struct GhostMesh {
  std::vector<Triangle> faces;   ///< indices of ghost vertices
  std::vector<Positions> poses;  ///< one pose per column of the shape
  /// For each ghost vertex: the shape vertex at its position; after optimal placement, the nearest vertex that
  /// collapsed to it.
  std::vector<int> vertexOf;
  /// For each shape vertex: the ghost vertex that it collapsed to, or -1.
  std::vector<int> ghostOf;
  int joinedComponents = 0;  ///< number of components too small for a ghost of their own
};

/// Uses one sequence of collapses for all poses. The cost of a collapse is the sum of its quadric errors over the
/// poses. A collapse is legal if it keeps the topology (collapse_mesh.h) and, in every pose, flips no face and makes
/// none too thin. Components keep at least half of their share of the faces, and at least four. If the target is too
/// small for that, the smallest join their neighbours.
///
/// Deterministic. Rigid motions of a pose have no effect: costs are compared to three digits, and ties are broken by
/// vertex. The result has more faces than requested if no legal collapse is left. Time: O(m log m) for bounded valence.
/// onProgress: fraction in [0, 1], called every few thousand steps.
GhostMesh simplify(const WeldedShape& shape, const ShapeTopology& topology, const SimplifyOptions& options,
                   const FractionReport& onProgress);

}  // namespace shapespline
