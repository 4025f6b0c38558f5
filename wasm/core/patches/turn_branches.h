// Direction in which a patch rotated relative to its neighbour between two poses: the branch of the increment's
// logarithm.
#pragma once

#include <vector>

#include "core/base/status.h"
#include "core/patches/patch_graph.h"
#include "core/rotation/rotation.h"

namespace shapespline {

/// The choices for one step between two poses.
struct TurnBranches {
  std::vector<Vec3> increment;  ///< increment of each link, with exp(increment) = C_from^T C_to
  /// For each link, the angle between the maps halfway and the rotations found there, radians.
  std::vector<double> residual;
};

/// Logarithms near 180 degrees do not determine their sense. For links with large rotations, the signs of the patches'
/// rotations do (turn_senses.h). from, to: the maps C = G_i^T G_j of each link in the two poses. turn: G_to G_from^T of
/// each patch. Error: the solver's.
Result<TurnBranches> chooseTurnBranches(const PatchGraph& graph, const std::vector<Quaternion>& from,
                                        const std::vector<Quaternion>& to, const std::vector<Quaternion>& turn);

}  // namespace shapespline
