#include "samples/pose.h"

#include <cmath>

namespace shapespline {
namespace {

Rigid turnAbout(const Vec3& centre, const Vec3& turn) {
  const double angle = turn.norm();
  if (angle == 0) return Rigid::Identity();
  return Eigen::Translation3d(centre) * Eigen::AngleAxisd(angle, turn / angle) * Eigen::Translation3d(-centre);
}

}  // namespace

void bend(Pose& pose, const Body& body, int limb, double from, double to, const Vec3& turn) {
  const int joints = body.limbs[limb].jointCount();
  std::vector<double> share(joints, 0.0);
  double sum = 0;
  for (int j = 0; j < joints; ++j) {
    const double t = (double(j) / (joints - 1) - from) / (to - from);
    if (t < 0 || t > 1) continue;
    share[j] = std::sin(M_PI * t) + 0.15;  // never zero, so that a part that holds one joint turns there
    sum += share[j];
  }
  const int first = body.firstJoint(limb);
  for (int j = 0; j < joints; ++j) pose.turns[first + j] += share[j] / sum * turn;
}

std::vector<Rigid> jointTransforms(const Body& body, const Pose& pose) {
  std::vector<Rigid> transforms;
  for (const Limb& limb : body.limbs) {
    Rigid carried = limb.parent < 0 ? pose.root : transforms[body.firstJoint(limb.parent) + limb.parentJoint];
    for (int j = 0; j < limb.jointCount(); ++j) {
      carried = carried * turnAbout(limb.centre[j], pose.turns[transforms.size()]);
      transforms.push_back(carried);
    }
  }
  return transforms;
}

}  // namespace shapespline
