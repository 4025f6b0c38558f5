// How patches turn against each other: the part of the coordinates (paper Eq. 5) that moves the faces' frames.
#pragma once

#include <vector>

#include "core/base/status.h"
#include "core/lri/welded_shape.h"
#include "core/patches/partition.h"
#include "core/patches/patch_graph.h"
#include "core/patches/turn_senses.h"
#include "core/spline/rotation_spline.h"

namespace shapespline {

struct PatchCoordinates {
  Patches patches;
  std::vector<std::vector<Quaternion>> rotation;  ///< G_k: rotation[column][patch]
  /// turn[step][patch]: G_to G_from^T, its sign the sense (turn_senses.h); empty for steps that there are not
  std::vector<std::vector<Quaternion>> turn;
  std::vector<std::vector<OpenTurn>> openTurns;  ///< openTurns[step]: those that the keys leave open; parts: patches
  std::vector<std::vector<Vec3>> pair;  ///< log(G_i^T G_j): pair[column][p] for patches.pairs[p], for the metric
  PatchGraph graph;  ///< links: patches.pairs in their order, then a bridge for each component but the root
  std::vector<int> bridgedComponent;          ///< the component that each bridge attaches
  RotationSplines connection;                 ///< C = G_from^T G_to of each link
  std::vector<std::vector<double>> residual;  ///< residual[step][link]: disagreement halfway (turn_branches.h), radians
};

/// Partitions the faces and encodes their patches in all poses. wantedPatches: 0 = default. Needs some component.
/// Error: that of the solver.
Result<PatchCoordinates> encodePatches(const WeldedShape& shape, const ShapeTopology& topology, int wantedPatches,
                                       const FractionReport& onProgress = {});

/// The part that follows from `rotation` alone: graph, connections and residuals. links: either way round; area: of
/// each patch.
Status encodeConnections(const WeldedShape& shape, std::vector<PatchLink> links, std::vector<double> area,
                         PatchCoordinates& patches);

/// The poses at either end of a step: columns of the shape, -1 where there is no such step.
struct StepPoses {
  int from, to;
};
StepPoses posesOf(const WeldedShape& shape, int step);

}  // namespace shapespline
