// Patch-based linear rotation-invariant coordinates of a set of poses (paper Eq. 5, after Baran et al. 2009).
#pragma once

#include <span>
#include <vector>

#include "core/component_tree.h"
#include "core/face_coordinates.h"
#include "core/options.h"
#include "core/patches.h"
#include "core/rotation.h"
#include "core/types.h"

namespace shapespline {

/// The welded mesh as the method sees it.
struct WeldedShape {
  std::vector<Triangle> faces;
  std::vector<Positions> poses;  ///< columns: the keys, then the end tangents where there are any
  int keys = 0;                  ///< how many of the poses are keys
  int startTangent = -1;         ///< pose index, or -1
  int endTangent = -1;
  int reference = 0;

  int vertexCount() const { return static_cast<int>(poses.front().size()); }
  int faceCount() const { return static_cast<int>(faces.size()); }
  int columns() const { return static_cast<int>(poses.size()); }
  /// The pose whose representatives the logarithms of `column` stay close to; -1 for the first.
  int before(int column) const {
    if (column == startTangent) return 0;
    if (column == endTangent) return keys - 1;
    return column - 1;
  }
};

/// A vertex in no face with area: it keeps its offset in the frame of an anchor face.
struct LooseVertex {
  int vertex;
  int anchorFace;
  std::vector<Vec3> offset;  ///< one a column: R_f^T (vertex - centroid of f)
};

/// How a component keeps its place at its anchor face.
struct ComponentHold {
  ComponentLink link;
  std::vector<Vec3> anchorRotation;  ///< one a column: log(G_p(a)^T R_a) of the anchor face a
  std::vector<Vec3> rotation;        ///< one a column: log(R_a^T G_p(b)) of the contact face b's patch
  std::vector<Vec3> offset;          ///< one a column: R_a^T (centroid of b - centroid of a)
};

/// A number of the coordinates that does not return to itself after one period: its closing representative minus the
/// first key's.
struct Winding {
  int index;  ///< face or pair
  Vec3 difference;
};

/// Coordinates of every pose. Logarithms take the representative nearest the pose before, so that a part may turn far.
template <class Real>
struct LriCoordinates {
  Patches patches;
  std::vector<double> patchArea;                   ///< in the reference pose
  std::vector<std::vector<Quaternion>> rotation;   ///< G_k: rotation[column][patch]
  std::vector<std::vector<Vec3>> pair;             ///< log(G_i^T G_j): pair[column][p] for patches.pairs[p]
  std::vector<double> pairWeight;                  ///< falls with the pair's largest turn
  FaceCoordinates<Real> face;
  Pieces pieces;
  ComponentTree tree;
  std::vector<ComponentHold> hold;                 ///< one a component; the root's is empty
  std::vector<LooseVertex> loose;
  std::vector<Vec3> meanPosition;                  ///< one a column: of all welded vertices
  std::vector<Winding> pairWinding, faceWinding;   ///< for a periodic curve with a closing interval
  std::vector<char> hasArea;                       ///< faces with area in every pose
  double largestPairTurn = 0;                      ///< largest change of a pair between consecutive keys, radians
};

/// Encodes all poses. wantedPatches: 0 = default. Needs some face with area in every pose.
template <class Real>
LriCoordinates<Real> encode(const WeldedShape& shape, int wantedPatches, Stretch stretch);

/// Weight of a patch pair whose largest turn over the poses is `angle` radians. Log branches cannot agree around a cycle
/// of patches where pairs turn by more than about 120 degrees; plain least squares would smear that error over the whole
/// body. Smooth shapes hardly change: ((1 + cos a) / 2)^6 is 1 - O(a^2).
double pairWeight(double angle);

}  // namespace shapespline
