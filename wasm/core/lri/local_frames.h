// Local frames for encoding faces: patches of the shape, or faces of a ghost mesh.
#pragma once

#include <span>
#include <vector>

#include "core/base/types.h"
#include "core/rotation/rotation.h"
#include "core/spline/spline.h"

namespace shapespline {

/// The frames of the encoded poses.
struct LocalFramePoses {
  std::span<const int> ofFace;                           ///< frame of each face, or -1 without area
  const std::vector<std::vector<Quaternion>>& rotation;  ///< rotation[column][frame]
};

/// The local frames at one time.
struct LocalFrames {
  std::vector<Quaternion> rotation;  ///< one per frame
  std::vector<Mat3> gradient;        ///< gradient per frame if faces follow more than the rotation; else empty
  std::vector<int> part;             ///< part of the curve that each frame follows (spline.h); empty without parts
};

}  // namespace shapespline
