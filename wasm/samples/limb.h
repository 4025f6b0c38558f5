// Bodies made of limbs: centre lines with a radius, which give both the surface (implicit.h) and the joints (pose.h).
#pragma once

#include <limits>
#include <optional>
#include <vector>

#include "core/base/types.h"

namespace shapespline {

/// A control point of a centre line and the radius of the limb there.
struct Knot {
  Vec3 centre;
  double radius;
};

/// Grooves along a limb, as on a cactus.
struct Ribs {
  int count = 0;     ///< 0 = none
  double depth = 0;  ///< of the grooves, as a fraction of the radius
};

/// A limb is flattened along one direction, as an ear is: its thickness there is `factor` times the radius.
struct Flattening {
  Vec3 direction = Vec3::UnitZ();
  double factor = 1;
};

/// A sphere around a stretch of a limb.
struct Bound {
  static constexpr int spans = 6;  ///< that it covers, from one joint to the next
  Vec3 middle;
  double radius;
};

/// A tube of varying radius with round ends about a curve that is sampled evenly by arc length; every sample is a
/// joint.
struct Limb {
  Positions centre;
  std::vector<double> radius;
  std::vector<Mat3> frame;  ///< columns: two normals, transported in parallel, and the tangent
  double blend = 0;         ///< width over which the limb melts into those before it
  double edge = 0;          ///< wanted edge length on its surface, where that gives 11 edges around it
  Ribs ribs;
  Flattening flattening;
  /// Share of its length from which on its surface follows its last joint alone.
  double rigidFrom = std::numeric_limits<double>::infinity();
  int parent = -1;            ///< limb that carries it; -1 for the root
  int parentJoint = 0;        ///< joint of that limb
  std::vector<Bound> bounds;  ///< of every Bound::spans spans

  int jointCount() const { return static_cast<int>(centre.size()); }
};

/// Limbs with every parent before its children.
struct Body {
  std::vector<Limb> limbs;
  std::optional<double> floor;  ///< the body is cut off below this y
  double floorRounding = 0;     ///< of the edge that this leaves

  int jointCount() const;
  int firstJoint(int limb) const;  ///< index of a limb's first joint among all joints
};

/// A limb along a Catmull-Rom curve through the knots, resampled to `joints` samples (at least 2).
Limb makeLimb(const std::vector<Knot>& knots, int joints);
/// The same with its wanted edge length and the width over which it melts into those before it.
Limb makeLimb(const std::vector<Knot>& knots, int joints, double edge, double blend);

/// Adds a limb that is attached to the joint of `parent` nearest to its own first joint. Returns its index.
int attach(Body& body, int parent, Limb limb);

/// The place on a limb nearest to a point.
struct LimbPoint {
  double along = 0;     ///< in joints: 2.25 is a quarter of the way from joint 2 to joint 3
  double distance = 0;  ///< from the limb's surface, negative inside; exact only near the surface of a plain limb
};

/// Wanted edge length on a limb at a joint.
double wantedEdge(const Limb& limb, int joint);

/// Looks no further than `limit`: where the limb is not nearer than that, the distance returned is `limit` or more and
/// `along` means nothing.
LimbPoint nearestOnLimb(const Limb& limb, const Vec3& point, double limit = std::numeric_limits<double>::max());

}  // namespace shapespline
