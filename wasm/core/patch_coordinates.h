// How patches turn against each other: the part of the coordinates (paper Eq. 5) that moves the faces' frames.
#pragma once

#include <vector>

#include "core/log_branches.h"
#include "core/patches.h"
#include "core/rotation.h"
#include "core/welded_shape.h"

namespace shapespline {

/// How a component keeps its rotation in its anchor face's R_a.
struct ComponentTurn {
  int piece;
  int anchorPatch, contactPatch;     ///< patches of the link's two faces
  std::vector<Vec3> anchorRotation;  ///< one a column: log(G_p(a)^T R_a)
  std::vector<Vec3> rotation;        ///< one a column: log(R_a^T G_p(b)), b the contact face
};

/// Logarithms take the representative nearest the pose before, so that a part may turn far.
struct PatchCoordinates {
  Patches patches;
  std::vector<double> area;                        ///< of each patch in the reference pose
  std::vector<std::vector<Quaternion>> rotation;   ///< G_k: rotation[column][patch]
  std::vector<std::vector<Vec3>> pair;             ///< log(G_i^T G_j): pair[column][p] for patches.pairs[p]
  std::vector<double> pairWeight;                  ///< falls with the pair's largest turn
  std::vector<Winding> pairWinding;                ///< for a periodic curve with a closing interval
  std::vector<ComponentTurn> turns;                ///< parents before children; the root has none
  double largestPairTurn = 0;                      ///< largest change of a pair between consecutive keys, radians
};

/// Partitions the faces and encodes their patches in all poses. wantedPatches: 0 = default. Needs some piece.
PatchCoordinates encodePatches(const WeldedShape& shape, const ShapeParts& parts, int wantedPatches,
                               const FractionReport& onProgress = {});

/// Weight of a patch pair whose largest turn over the poses is `angle` radians. Log branches cannot agree around a cycle
/// of patches where pairs turn by more than about 120 degrees; plain least squares would smear that error over the whole
/// body. Smooth shapes hardly change: ((1 + cos a) / 2)^6 is 1 - O(a^2).
double pairWeight(double angle);

}  // namespace shapespline
