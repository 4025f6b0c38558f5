// Directions in which parts of a shape rotated between two poses. They belong to the mesh, not to a partition.
#pragma once

#include <vector>

#include "core/rotation/rotation.h"

namespace shapespline {

/// Two connected parts of a shape: faces with a common edge, or patches.
struct TurnJoint {
  int first, second;
  double length;  ///< length of the joint, in any unit
};

/// A set of parts with an ambiguous direction of rotation.
struct OpenTurn {
  int part;      ///< a part in the set
  double angle;  ///< rotation of the set relative to its neighbours: the mean over its joints, radians
  double share;  ///< share of the total area
};

/// Chooses the senses of the parts' rotations, as signs of unit quaternions. A rotation has two quaternions, q and -q:
/// rotations by a and by a - 360 degrees about one axis. A joint rotates by 2 acos(p . q), which is less than 180
/// degrees if the quaternions of its parts agree. turn: one per part; its sign is changed in place. Joints that rotate
/// by less than 60 degrees in either sense are trusted one by one, the smallest rotation first. Then sets of parts are
/// joined, in descending order of the evidence of their joints: the sum of length (pi - angle), reduced if joints
/// contradict each other. So small rotations decide, and longer boundaries count more. Signs of unconnected parts are
/// independent. area: one per part. Returns the sets whose joints rotate by 144 degrees or more on average, or
/// contradict each other as much.
std::vector<OpenTurn> chooseTurnSenses(const std::vector<TurnJoint>& joints, const std::vector<double>& area,
                                       std::vector<Quaternion>& turn);

}  // namespace shapespline
