// What no face of its own moves: components at the joints where others carry them, vertices in no face with area.
#pragma once

#include <vector>

#include "core/base/types.h"
#include "core/lri/local_frames.h"
#include "core/lri/welded_shape.h"

namespace shapespline {

/// A vertex in no face with area: it keeps its offset in the frame of an anchor face.
struct LooseVertex {
  int vertex;
  int anchorFace, anchorFrame;
  std::vector<Vec3> offset;  ///< one per column: R_f^T (vertex - centroid of f)
};

/// How a component b keeps its place at its anchor face a: by the point that moves least against both in all poses,
/// such as the axle of a wheel or the joint of a hoof. A point elsewhere would be splined along chords while the
/// component turns.
struct ComponentJoint {
  int component;
  int anchorFace, contactFace;  ///< the link's two faces
  int anchorFrame, contactFrame;
  Vec3 pivot;                ///< R_b^T (that point - centroid of b), the same in every column
  std::vector<Vec3> offset;  ///< one per column: R_a^T (that point - centroid of a)
};

struct CarriedComponents {
  std::vector<ComponentJoint> joints;  ///< parents before children; the root has none
  std::vector<LooseVertex> loose;
};

/// facesRest: R_f is that of the face's frame, in every column.
CarriedComponents encodeCarriedComponents(const WeldedShape& shape, const ShapeTopology& topology,
                                          const LocalFramePoses& frames, bool facesRest);

}  // namespace shapespline
