// A report on the mesh, before any computation.
#pragma once

#include "core/mesh/mesh.h"
#include "core/sequence/keyframes.h"

namespace shapespline {

/// Counts of the input. Edges and components are those of the welded mesh, so seams are not boundaries.
struct MeshReport {
  int vertices = 0;
  int weldedVertices = 0;
  int faces = 0;
  int components = 0;            ///< components without common welded vertices, ignoring faces without area
  int degenerateFaces = 0;       ///< without area in some key
  int unreferencedVertices = 0;  ///< unused input vertices
  MeshCounts counts;
  double diagonal = 0;  ///< diagonal of the bounding box of all keys
};

/// The keys must have passed validate().
MeshReport reportOf(const Keyframes& keyframes, const FractionReport& onProgress = {});

}  // namespace shapespline
