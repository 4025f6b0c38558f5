// Costs of building and evaluating a sequence.
#pragma once

#include "core/space/lri_space.h"

namespace shapespline {

/// Costs of the encoded shape so far.
struct BuildStats : LriStats {
  int weldedVertices = 0;
  int components = 0;
  /// Wall time of each stage. Joining: finds faces with area, their neighbours and components.
  double weldMs = 0, joinMs = 0;
};

/// Costs of the evaluator.
struct FrameStats {
  long long solves = 0;  ///< solves of the full-resolution system
  /// Wall time of the last frame's parts: local frames (of patches or of a ghost's faces); splined faces and right-hand
  /// side; the full-resolution solve; positions; normals and drawing data in raw vertex order.
  double localFramesMs = 0, facesMs = 0, solveMs = 0, positionsMs = 0, normalsMs = 0;
  double ghostMs = 0;  ///< wall time of the ghost's last shape, from the spline to its vertices
};

struct SequenceStats : BuildStats, FrameStats {};

}  // namespace shapespline
