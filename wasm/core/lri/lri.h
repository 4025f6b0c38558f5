// Linear rotation-invariant coordinates of a set of poses (paper Eq. 5, after Baran et al. 2009): what stands in the
// frames that patches, or the faces of a ghost mesh, give to the faces.
#pragma once

#include <vector>

#include "core/base/types.h"
#include "core/lri/carried_components.h"
#include "core/lri/face_coordinates.h"
#include "core/lri/local_frames.h"
#include "core/lri/welded_shape.h"

namespace shapespline {

/// How the full-resolution shape follows a ghost mesh (paper section 4.3).
enum class Transfer {
  Exact,  ///< what the keys show beyond the ghost's motion is splined too: passes through every key
  Paper,  ///< the reference's details follow the ghost; other keys are met up to their own details
};

/// Faces that turn so far within their frames from one key to the next that the keys do not say which way.
struct AmbiguousFaces {
  int count = 0;
  int worst = -1;   ///< the one that turns furthest
  double area = 0;  ///< over that of the shape, in the reference pose
};

/// Coordinates of every pose in given frames G. Logarithms take the representative nearest the pose before, so a part
/// may turn far.
template <class Real>
struct LriCoordinates {
  FaceCoordinates<Real> face;          ///< log(G^T R_f) and S_f; no column is stored where faces rest in their frames
  std::vector<ComponentJoint> joints;  ///< parents before children; the root has none
  std::vector<LooseVertex> loose;
  std::vector<Vec3> meanPosition;         ///< one per column: of all welded vertices
  std::vector<AmbiguousFaces> ambiguous;  ///< one per interval between keys
};

/// Encodes all poses in the given frames. With Transfer::Paper faces rest in their frames as they do in the reference.
template <class Real>
LriCoordinates<Real> encode(const WeldedShape& shape, const ShapeTopology& topology, const LocalFramePoses& frames,
                            Stretch stretch, Transfer transfer, const FractionReport& onProgress = {});

}  // namespace shapespline
