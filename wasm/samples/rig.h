// Body + poses -> keyframes.
#pragma once

#include "core/sequence/keyframes.h"
#include "samples/limb.h"
#include "samples/pose.h"

namespace shapespline {

/// Meshes the body, binds the mesh with `smoothing` rounds and poses it; key j is at time j * spacing.
Keyframes posedKeyframes(const Body& body, const std::vector<Pose>& poses, double spacing, int smoothing);

}  // namespace shapespline
