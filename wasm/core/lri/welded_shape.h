// The welded mesh as the method sees it: its poses, and which of its faces take part.
#pragma once

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

/// All poses of a shape: the keys, and the shapes that stand for end tangents where there are any.
struct WeldedShape {
  std::vector<Triangle> faces;
  std::vector<Positions> poses;  ///< columns: the keys, then the end tangents where there are any
  int keys = 0;                  ///< how many of the poses are keys
  int startTangent = -1;         ///< pose index, or -1
  int endTangent = -1;
  int reference = 0;
  /// The motion that takes the first key to the last, where it takes all of it there.
  std::optional<RigidMotion> closing;

  PoseRoles roles() const { return {keys, startTangent, endTangent}; }
  int vertexCount() const { return static_cast<int>(poses.front().size()); }
  int faceCount() const { return static_cast<int>(faces.size()); }
  int columns() const { return static_cast<int>(poses.size()); }
  /// The pose whose representatives the logarithms of `column` stay close to; -1 for the first.
  int before(int column) const {
    if (column == startTangent) return 0;
    if (column == endTangent) return keys - 1;
    return column - 1;
  }
  /// Whether a column is the last key of a loop, which is the first one again: it counts once where all poses count
  /// alike.
  bool repeatsFirst(int column) const { return closing && column == keys - 1; }
  /// Another mesh with as many poses, which play the same roles.
  WeldedShape withMesh(std::vector<Triangle> otherFaces, std::vector<Positions> otherPoses) const {
    return {std::move(otherFaces), std::move(otherPoses), keys, startTangent, endTangent, reference, closing};
  }
};

FaceFrame referenceFrame(const WeldedShape& shape, int face);

/// R_f and S_f of a face that has area, in one pose. frame: its referenceFrame().
FaceDeformation deformationOf(const WeldedShape& shape, int face, const FaceFrame& frame, int column);
Quaternion rotationOf(const WeldedShape& shape, int face, int column);

/// The faces that have area in every pose, and the components that they form.
struct ShapeTopology {
  std::vector<char> hasArea;
  FaceGraph graph;  ///< of those faces
  Components components;
  ComponentTree tree;  ///< empty where there is no component

  /// The faces that take part, in order.
  template <class Visit>
  void eachUsedFace(Visit visit, const FractionReport& onProgress = {}) const {
    inBlocks(onProgress, hasArea.size(), [&](std::size_t begin, std::size_t end) {
      for (std::size_t f = begin; f < end; ++f)
        if (hasArea[f]) visit(static_cast<int>(f));
    });
  }
};

ShapeTopology topologyOf(const WeldedShape& shape, const FractionReport& onProgress = {});

}  // namespace shapespline
