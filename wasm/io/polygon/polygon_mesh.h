// A polygon mesh, as in OBJ, PLY and OFF, and its triangles.
#pragma once

#include <string>
#include <vector>

#include "core/base/status.h"
#include "core/base/types.h"
#include "core/base/warning.h"
#include "io/base/scene.h"

namespace shapespline {

/// One pose as stored in a file.
struct PolygonMesh {
  Positions positions;
  Positions normals;                 ///< n unit vectors, or empty
  std::vector<int> corners;          ///< vertex index for every corner of every polygon, in range
  std::vector<int> drawn;            ///< drawn vertex for every corner if there are seams, else empty
  std::vector<int> ends;             ///< end of each polygon in `corners`; at least 3 corners each
  Scene scene;                       ///< groups and objects count polygons, not triangles
  std::vector<std::string> objects;  ///< object names, each once
  bool writtenZUp = false;           ///< written by a program that uses Z up in this format
  Vec3 offset = Vec3::Zero();        ///< offset stated in a comment; the positions are relative to it
  std::vector<Warning> warnings;

  int polygonCount() const { return static_cast<int>(ends.size()); }
  int firstCorner(int polygon) const { return polygon == 0 ? 0 : ends[polygon - 1]; }
};

/// Moves vertices without faces to a used vertex if they are not finite. They have no effect on the shape.
void placeUnused(PolygonMesh& mesh);

/// The triangles of every polygon in sequence, as corner numbers within the polygon.
using PolygonCuts = std::vector<Triangle>;

/// Chooses cuts from one pose: the shorter inner diagonal of a quad, ears of larger polygons.
PolygonCuts cutPolygons(const PolygonMesh& mesh);

/// Recovers the cuts that turned a mesh with the same polygons into these triangles. Falls back to the mesh's own cuts
/// if the triangles cannot match.
PolygonCuts cutPolygonsLike(const PolygonMesh& mesh, const std::vector<Triangle>& triangles);

/// Cuts a mesh with the given cuts, so every key gets the same triangles. If polygon sizes differ, each polygon becomes
/// a fan. The keys then do not match, and a later comparison reports that.
std::vector<Triangle> trianglesOf(const PolygonMesh& mesh, const PolygonCuts& cuts);

/// The same triangles in terms of drawn vertices; empty without seams.
std::vector<Triangle> drawnTrianglesOf(const PolygonMesh& mesh, const PolygonCuts& cuts);

/// Number of triangles of each polygon; empty if all polygons are triangles.
std::vector<int> trianglesPerPolygon(const PolygonMesh& mesh);

/// Converts groups of polygons to groups of triangles.
std::vector<MaterialGroup> triangleGroups(const PolygonMesh& mesh);

/// Converts objects of polygons to objects of triangles.
std::vector<ObjectFaces> triangleObjects(const PolygonMesh& mesh);

}  // namespace shapespline
