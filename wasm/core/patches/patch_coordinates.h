// Rotations of patches relative to each other: the part of the coordinates (paper Eq. 5) that moves the faces' frames.
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
  int origin = 0;                ///< the key that partition and mean rotations are relative to (central_key.h)
  std::vector<double> faceArea;  ///< in the origin, times the share of a face that is not torn; 0 without area
  std::vector<std::vector<Quaternion>> rotation;  ///< G_k: rotation[column][patch]
  /// turn[step][patch]: G_to G_from^T, with the sense as its sign (turn_senses.h); empty for missing steps
  std::vector<std::vector<Quaternion>> turn;
  std::vector<std::vector<OpenTurn>> openTurns;  ///< openTurns[step]: ambiguous turns; parts are patches
  std::vector<std::vector<Vec3>> pair;  ///< log(G_i^T G_j): pair[column][p] for patches.pairs[p], for the metric
  PatchGraph graph;  ///< links: patches.pairs in order, then a bridge for each component except the root
  std::vector<int> bridgedComponent;          ///< the component attached by each bridge
  RotationSplines connection;                 ///< C = G_from^T G_to of each link
  std::vector<std::vector<double>> residual;  ///< residual[step][link]: disagreement halfway (turn_branches.h), radians
};

/// Partitions the faces and encodes their patches in all poses. wantedPatches: 0 = default. Requires at least one
/// component. Error: the solver's.
Result<PatchCoordinates> encodePatches(const WeldedShape& shape, const ShapeTopology& topology, int wantedPatches,
                                       const FractionReport& onProgress = {});

/// Computes the part that depends only on `rotation`: graph, connections and residuals. links: in any direction. area:
/// one per patch.
Status encodeConnections(const WeldedShape& shape, std::vector<PatchLink> links, std::vector<double> area,
                         PatchCoordinates& patches);

/// Poses at the ends of a step: columns of the shape, or -1 for a missing step.
struct StepPoses {
  int from, to;
};
StepPoses posesOf(const WeldedShape& shape, int step);

}  // namespace shapespline
