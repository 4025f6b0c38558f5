// Components and vertices that follow an anchor face: components at their joints, and vertices without a face with
// area.
#pragma once

#include <vector>

#include "core/base/types.h"
#include "core/lri/local_frames.h"
#include "core/lri/welded_shape.h"

namespace shapespline {

/// A vertex without a face with area. It keeps its offset in the frame of an anchor face.
struct LooseVertex {
  int vertex;
  int anchorFace, anchorFrame;
  std::vector<Vec3> offset;  ///< one per column: R_f^T (vertex - centroid of f)
};

/// Joint of a component b at its anchor face a: the point that moves least relative to both in all poses, such as the
/// axle of a wheel or the joint of a hoof. Any other point would move along chords while the component rotates.
struct ComponentJoint {
  int component;
  int anchorFace, contactFace;  ///< faces of the link
  int anchorFrame, contactFrame;
  Vec3 pivot;                ///< R_b^T (joint - centroid of b), equal in every column
  std::vector<Vec3> offset;  ///< per column: R_a^T (joint - centroid of a)
};

struct CarriedComponents {
  std::vector<ComponentJoint> joints;  ///< parents before children; none for the root
  std::vector<LooseVertex> loose;
};

/// facesRest: R_f equals the rotation of the face's frame in every column.
CarriedComponents encodeCarriedComponents(const WeldedShape& shape, const ShapeTopology& topology,
                                          const LocalFramePoses& frames, bool facesRest);

}  // namespace shapespline
