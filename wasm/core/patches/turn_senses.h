// Which way parts of a shape turned from one pose to the next: a property of the mesh, found before any partition.
#pragma once

#include <vector>

#include "core/rotation/rotation.h"

namespace shapespline {

/// Two parts of a shape that are joined: faces that share an edge, or patches.
struct TurnJoint {
  int first, second;
  double length;  ///< of the joint, in any unit
};

/// A set of parts that may as well have turned the other way.
struct OpenTurn {
  int part;      ///< one of the set
  double angle;  ///< by which the set turns against its neighbours: the mean over its joints, radians
  double share;  ///< of the area of all parts
};

/// The turns of parts as unit quaternions whose signs say their senses. A rotation has two quaternions, q and -q: turns
/// by a and by a - 360 degrees about one axis. A joint turns by 2 acos(p . q): by less than half a turn where the
/// quaternions of its parts agree.
///
/// turn: of each part, its sign changed in place. Joints that turn by less than 60 degrees either way are believed one
/// by one, the smallest turn first. Then sets of parts are joined, those first whose joints say most: the sum of
/// length (pi - angle), less where they contradict each other. So small turns decide, and of two sides the longer one.
/// Signs of parts that nothing joins are independent. area: of each part. Returns the sets whose joints turn by 144
/// degrees or more in the mean, or contradict each other as much.
std::vector<OpenTurn> chooseTurnSenses(const std::vector<TurnJoint>& joints, const std::vector<double>& area,
                                       std::vector<Quaternion>& turn);

}  // namespace shapespline
