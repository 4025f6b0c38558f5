// Which way a patch turned against its neighbour from one pose to the next: the branch of the increment's logarithm.
#pragma once

#include <vector>

#include "core/base/status.h"
#include "core/patches/patch_graph.h"
#include "core/rotation/rotation.h"

namespace shapespline {

/// What is chosen for one step between two poses.
struct TurnBranches {
  std::vector<Vec3> increment;  ///< of each link: its exp is C_from^T C_to
  /// Of each link: the angle by which the maps halfway disagree with the rotations found there, radians.
  std::vector<double> residual;
};

/// Logarithms near half a turn do not say their sense; the signs of the patches' turns do (turn_senses.h), where a link
/// turns far. from, to: the maps C = G_i^T G_j of each link in the two poses; turn: G_to G_from^T of each patch. Error:
/// that of the solver.
Result<TurnBranches> chooseTurnBranches(const PatchGraph& graph, const std::vector<Quaternion>& from,
                                        const std::vector<Quaternion>& to, const std::vector<Quaternion>& turn);

}  // namespace shapespline
