// Poses of a body: a turn at every joint.
#pragma once

#include <vector>

#include <Eigen/Geometry>

#include "samples/limb.h"

namespace shapespline {

using Rigid = Eigen::Isometry3d;

/// Rotation vectors, in the axes of the rest pose, about each joint; everything further along the limb and every limb
/// that is attached there follows.
struct Pose {
  explicit Pose(const Body& body) : turns(body.jointCount(), Vec3::Zero()) {}
  std::vector<Vec3> turns;
  Rigid root = Rigid::Identity();  ///< applied after all turns
};

/// Spreads a turn over the part of a limb between two fractions of its length, as a smooth hump.
void bend(Pose& pose, const Body& body, int limb, double from, double to, const Vec3& turn);

/// Rest -> pose, for each joint.
std::vector<Rigid> jointTransforms(const Body& body, const Pose& pose);

}  // namespace shapespline
