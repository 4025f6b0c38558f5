// A polygon mesh, as in OBJ, PLY and OFF, and its triangles.
#pragma once

#include <string>
#include <vector>

#include "core/base/status.h"
#include "core/base/types.h"
#include "core/base/warning.h"
#include "io/base/scene.h"

namespace shapespline {

/// One pose as it stands in a file.
struct PolygonMesh {
  Positions positions;
  Positions normals;                 ///< n unit vectors, or empty
  std::vector<int> corners;          ///< vertex of every corner of every polygon, in range
  std::vector<int> drawn;            ///< drawn vertex of every corner with seams, else empty
  std::vector<int> ends;             ///< of each polygon: one past its last corner; at least 3 corners each
  Scene scene;                       ///< its groups and objects count polygons
  std::vector<std::string> objects;  ///< names, each once
  bool writtenZUp = false;           ///< by a program whose files of this kind have z up
  Vec3 offset = Vec3::Zero();        ///< stated in a comment: the positions are relative to it
  std::vector<Warning> warnings;

  int polygonCount() const { return static_cast<int>(ends.size()); }
  int firstCorner(int polygon) const { return polygon == 0 ? 0 : ends[polygon - 1]; }
};

/// How every polygon is cut: triangles of corner numbers counted within the polygon, polygon after polygon.
using PolygonCuts = std::vector<Triangle>;

/// Chooses the cuts from one pose: the diagonal of a quad that lies inside and is shorter, ears of larger polygons.
PolygonCuts cutPolygons(const PolygonMesh& mesh);

/// The cuts that turned a mesh with the same polygons into these triangles; the mesh's own cuts if it cannot match.
PolygonCuts cutPolygonsLike(const PolygonMesh& mesh, const std::vector<Triangle>& triangles);

/// The triangles of a mesh under given cuts, so every key is split the same way. If the polygons have different sizes,
/// each is split as a fan: the keys do not match then, and comparing them reports that.
std::vector<Triangle> trianglesOf(const PolygonMesh& mesh, const PolygonCuts& cuts);

/// The same triangles in drawn vertices; empty without seams.
std::vector<Triangle> drawnTrianglesOf(const PolygonMesh& mesh, const PolygonCuts& cuts);

/// Number of triangles of each polygon; empty where all polygons are triangles.
std::vector<int> trianglesPerPolygon(const PolygonMesh& mesh);

/// Groups of triangles from groups of polygons.
std::vector<MaterialGroup> triangleGroups(const PolygonMesh& mesh);

/// Objects of triangles from objects of polygons.
std::vector<ObjectFaces> triangleObjects(const PolygonMesh& mesh);

}  // namespace shapespline
