// Skinning: how a surface follows the joints of its body.
#pragma once

#include <vector>

#include "samples/pose.h"
#include "samples/surface.h"

namespace shapespline {

/// A vertex's share in a joint; a vertex's shares sum to 1.
struct Share {
  int joint;
  double weight;
};
using Binding = std::vector<std::vector<Share>>;

/// Binds every vertex to its nearest joints, then smooths the shares over the surface, `rounds` times, but for those at
/// the rigid end of a limb.
Binding bindSurface(const Surface& surface, const Body& body, int rounds);

/// The surface in a pose, by dual-quaternion blending (Kavan et al. 2007), which keeps the volume where limbs bend.
Positions skin(const Surface& surface, const Binding& binding, const std::vector<Rigid>& joints);

}  // namespace shapespline
