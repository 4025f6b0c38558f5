// Input for holding a shape.
#pragma once

#include <vector>

#include "core/base/precision.h"
#include "core/hold/hold_system.h"
#include "core/rotation/rotation.h"

namespace shapespline {

/// All members must outlive the objects created from them.
struct HoldInput {
  HoldMesh mesh;
  const std::vector<int>& patchOfFace;                   ///< patch of each face, -1 without area
  const std::vector<std::vector<Quaternion>>& rotation;  ///< rotation[column][frame]
  Precision precision;
};

}  // namespace shapespline
