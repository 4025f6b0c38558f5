// What building and evaluating a sequence cost.
#pragma once

namespace shapespline {

/// Of the encoded shape: neither encodings nor factorisations move while t, the motion options or the key times change.
/// What a motion factorises to hold what rests is not counted.
struct BuildStats {
  int encodings = 0;
  int factorisations = 0;
  int patches = 0;  ///< of the ghost, with one
  int weldedVertices = 0;
  int components = 0;
  /// Wall time of each stage; the ghost's own systems count as encoding. Joining: which faces have area, what they
  /// border on and which components they form. Arranging lays the faces' numbers out in the order in which the system
  /// is eliminated. Finishing: normals, what is told of the input's faces, warnings.
  double weldMs = 0, joinMs = 0, encodeMs = 0, orderMs = 0, factorMs = 0, arrangeMs = 0, finishMs = 0;
  long long factorBytes = 0;  ///< of the stored factor, entries and row lists: what one sweep of a solve reads
  int ghostFaces = 0, ghostVertices = 0;  ///< 0 without a ghost
  int joinedComponents = 0;               ///< components too small for a ghost of their own
  double simplifyMs = 0, transferMs = 0;  ///< with a ghost: collapses; correspondence and residuals
};

/// Of the evaluator.
struct FrameStats {
  long long solves = 0;  ///< of the full-resolution system
  /// Wall time of the last frame's parts: the frames that faces stand in (of patches or of a ghost's faces); splined
  /// faces and right-hand side; the full-resolution solve; placing the vertices; normals and what is drawn, in the
  /// order of the raw vertices.
  double framesMs = 0, facesMs = 0, solveMs = 0, placeMs = 0, normalsMs = 0;
  double ghostMs = 0;  ///< wall time of the ghost's own last shape, from the spline to its vertices
};

struct SequenceStats : BuildStats, FrameStats {};

}  // namespace shapespline
