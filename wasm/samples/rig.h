// Body + poses -> keyframes.
#pragma once

#include "core/keyframes.h"
#include "samples/limb.h"
#include "samples/pose.h"

namespace shapespline {

/// Meshes the body, binds the mesh with `smoothing` rounds and poses it; times are spread evenly over [0, 1].
Keyframes posedKeyframes(const Body& body, const std::vector<Pose>& poses, int smoothing);

}  // namespace shapespline
