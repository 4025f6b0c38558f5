// What is worth saying about a set of keys before anything is computed with them.
#pragma once

#include "core/mesh/mesh.h"
#include "core/sequence/keyframes.h"

namespace shapespline {

/// Counts of the input; edges and components are those of the welded mesh, so seams are no boundary.
struct MeshReport {
  int vertices = 0;
  int weldedVertices = 0;
  int faces = 0;
  int components = 0;            ///< components that share no welded vertex, faces without area left out
  int degenerateFaces = 0;       ///< without area in some key
  int unreferencedVertices = 0;  ///< of the input, in no face
  MeshCounts counts;
  double diagonal = 0;  ///< of the box around all keys
};

/// Of keys that passed validate().
MeshReport reportOf(const Keyframes& keyframes, const FractionReport& onProgress = {});

}  // namespace shapespline
