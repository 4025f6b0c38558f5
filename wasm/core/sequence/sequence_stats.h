// What building and evaluating a sequence cost.
#pragma once

#include "core/space/lri_space.h"

namespace shapespline {

/// Of the encoded shape: what was made so far.
struct BuildStats : LriStats {
  int weldedVertices = 0;
  int components = 0;
  /// Wall time of each stage. Joining: which faces have area, what they border on and which components they form.
  double weldMs = 0, joinMs = 0;
};

/// Of the evaluator.
struct FrameStats {
  long long solves = 0;  ///< of the full-resolution system
  /// Wall time of the last frame's parts: the frames that faces stand in (of patches or of a ghost's faces); splined
  /// faces and right-hand side; the full-resolution solve; placing the vertices; normals and what is drawn, in the
  /// order of the raw vertices.
  double localFramesMs = 0, facesMs = 0, solveMs = 0, positionsMs = 0, normalsMs = 0;
  double ghostMs = 0;  ///< wall time of the ghost's own last shape, from the spline to its vertices
};

struct SequenceStats : BuildStats, FrameStats {};

}  // namespace shapespline
