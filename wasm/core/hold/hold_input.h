// The shape that is held, as what holds it is given it.
#pragma once

#include <vector>

#include "core/base/precision.h"
#include "core/hold/hold_system.h"
#include "core/rotation/rotation.h"

namespace shapespline {

/// All of it must outlive what is made of it.
struct HoldInput {
  HoldMesh mesh;
  const std::vector<int>& patchOfFace;                   ///< -1 without area
  const std::vector<std::vector<Quaternion>>& rotation;  ///< rotation[column][frame]
  Precision precision;
};

}  // namespace shapespline
