// Where the frames come from that faces are encoded in: patches of the shape itself, or the faces of a ghost mesh.
#pragma once

#include <span>
#include <vector>

#include "core/base/types.h"
#include "core/rotation/rotation.h"
#include "core/spline/spline.h"

namespace shapespline {

/// The frames of the poses that are encoded.
struct LocalFramePoses {
  std::span<const int> ofFace;                           ///< frame of each face; -1 where it has no area
  const std::vector<std::vector<Quaternion>>& rotation;  ///< rotation[column][frame]
};

/// The frames at one time.
struct LocalFrames {
  std::vector<Quaternion> rotation;  ///< one per frame
  std::vector<Mat3> gradient;        ///< what faces are multiplied by, where that is more than the rotation; else empty
};

}  // namespace shapespline
