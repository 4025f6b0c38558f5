// Linear rotation-invariant coordinates of a set of poses (paper Eq. 5, after Baran et al. 2009), relative to the local
// frames of patches or of a ghost mesh's faces.
#pragma once

#include <vector>

#include "core/base/types.h"
#include "core/lri/carried_components.h"
#include "core/lri/face_coordinates.h"
#include "core/lri/local_frames.h"
#include "core/lri/torn_faces.h"
#include "core/lri/welded_shape.h"

namespace shapespline {

/// How the full-resolution shape follows a ghost mesh (paper section 4.3).
enum class Transfer {
  Exact,  ///< splines the differences between keys and ghost motion too: passes through every key
  Paper,  ///< the reference's details follow the ghost; other keys are matched except for their own details
};

/// Faces with rotations so large between two keys that the direction is ambiguous.
struct AmbiguousFaces {
  int count = 0;
  int worst = -1;   ///< the face with the largest rotation
  double area = 0;  ///< share of the shape's area, in the reference pose
};

/// Coordinates of every pose in given frames G. Each logarithm uses the representative nearest to the previous pose, so
/// rotations may be large.
template <class Real>
struct LriCoordinates {
  FaceCoordinates<Real> face;          ///< log(G^T R_f) and S_f; columns with all faces at rest are not stored
  std::vector<ComponentJoint> joints;  ///< parents before children; none for the root
  std::vector<LooseVertex> loose;
  std::vector<TornFace> torn;
  std::vector<Vec3> meanPosition;         ///< per column: mean of all welded vertices
  std::vector<AmbiguousFaces> ambiguous;  ///< one entry per interval between keys
};

/// Encodes all poses in the given frames. With Transfer::Paper, faces rest in their frames in all poses.
template <class Real>
LriCoordinates<Real> encode(const WeldedShape& shape, const ShapeTopology& topology, const LocalFramePoses& frames,
                            Stretch stretch, Transfer transfer, const FractionReport& onProgress = {});

}  // namespace shapespline
