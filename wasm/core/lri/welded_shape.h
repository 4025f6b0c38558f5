// The welded mesh for the method: its poses, and its faces with area.
#pragma once

#include <algorithm>
#include <optional>
#include <utility>
#include <vector>

#include "core/base/types.h"
#include "core/lri/face_frame.h"
#include "core/mesh/component_tree.h"
#include "core/mesh/mesh.h"
#include "core/rotation/rigid_motion.h"
#include "core/spline/pose_roles.h"

namespace shapespline {

/// All poses of a shape: the keys, and the optional shapes for end tangents.
struct WeldedShape {
  std::vector<Triangle> faces;
  std::vector<Positions> poses;  ///< columns: the keys, then any end tangents
  int keys = 0;                  ///< number of poses that are keys
  int startTangent = -1;         ///< pose index, or -1
  int endTangent = -1;
  int reference = 0;
  /// The rigid motion from the first key to the last, if one exists.
  std::optional<RigidMotion> closing;

  PoseRoles roles() const { return {keys, startTangent, endTangent}; }
  int vertexCount() const { return static_cast<int>(poses.front().size()); }
  int faceCount() const { return static_cast<int>(faces.size()); }
  int columns() const { return static_cast<int>(poses.size()); }
  /// The pose that determines the representatives of the logarithms of `column`; -1 for the first.
  int before(int column) const {
    if (column == startTangent) return 0;
    if (column == endTangent) return keys - 1;
    return column - 1;
  }
  /// Whether a column is the last key of a loop, a copy of the first key. Averages over poses count it once.
  bool repeatsFirst(int column) const { return closing && column == keys - 1; }
  /// The same pose roles for another mesh with the same number of poses.
  WeldedShape withMesh(std::vector<Triangle> otherFaces, std::vector<Positions> otherPoses) const {
    return {std::move(otherFaces), std::move(otherPoses), keys, startTangent, endTangent, reference, closing};
  }
};

FaceFrame frameIn(const WeldedShape& shape, int face, int column);
FaceFrame referenceFrame(const WeldedShape& shape, int face);

/// R_f and S_f in one pose of a face with area, relative to `frame`.
FaceDeformation deformationOf(const WeldedShape& shape, int face, const FaceFrame& frame, int column);
Quaternion rotationOf(const WeldedShape& shape, int face, int column);

/// The faces that carry rotations: those with area in every pose, except torn ones. And their components.
struct ShapeTopology {
  std::vector<char> turns;  ///< whether each face carries a rotation
  FaceGraph graph;          ///< graph of these faces
  Components components;
  ComponentTree tree;  ///< empty without components

  std::vector<char> hasArea;  ///< the faces of the second system
  Components solved;          ///< their components, which may consist of several of the components above
  std::vector<double> torn;   ///< how much each face is torn (torn_faces.h); empty if no face is
  /// The face with a rotation that each face follows: itself, or the nearest one along the mesh for torn faces. -1 for
  /// faces without area.
  std::vector<int> anchor;

  /// Visits the faces that carry rotations, in order.
  template <class Visit>
  void eachUsedFace(Visit visit, const FractionReport& onProgress = {}) const {
    inBlocks(onProgress, turns.size(), [&](std::size_t begin, std::size_t end) {
      for (std::size_t f = begin; f < end; ++f)
        if (turns[f]) visit(static_cast<int>(f));
    });
  }
  int usedFaces() const { return static_cast<int>(std::count(turns.begin(), turns.end(), 1)); }
  /// How much a face counts with its rotation.
  double whole(int face) const { return torn.empty() ? 1 : 1 - torn[face]; }
};

ShapeTopology topologyOf(const WeldedShape& shape, const FractionReport& onProgress = {});

}  // namespace shapespline
