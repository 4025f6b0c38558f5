// A saguaro: a ribbed trunk with two arms, bent one way, upright, and bent in the orthogonal plane (paper Fig. 1).
#include "samples/rig.h"
#include "samples/sample.h"

namespace shapespline {
namespace {

constexpr double trunkEdge = 0.067, armEdge = 0.058;  // five to a rib
enum { trunk, leftArm, rightArm };

Limb ribbed(Limb limb, int ribs, double depth, double edge, double blend) {
  limb.edge = edge;
  limb.ribs = {ribs, depth};
  limb.blend = blend;
  return limb;
}

Body makeBody() {
  Body body;
  body.floor = 0;
  body.floorRounding = 0.12;
  attach(body, -1, ribbed(makeLimb({{{0, 0, 0}, 0.54}, {{0, 0.55, 0}, 0.44}, {{0, 1.9, 0}, 0.47},
                                    {{0, 3.4, 0}, 0.475}, {{0, 4.35, 0}, 0.43}}, 46), 9, 0.26, trunkEdge, 0));
  attach(body, trunk, ribbed(makeLimb({{{0, 1.55, 0}, 0.22}, {{-0.5, 1.52, 0.02}, 0.235}, {{-0.93, 1.62, 0.05}, 0.27},
                                       {{-1.17, 2.0, 0.08}, 0.29}, {{-1.23, 2.6, 0.1}, 0.295}, {{-1.2, 3.2, 0.1}, 0.265}}, 30),
                             6, 0.24, armEdge, 0.2));
  attach(body, trunk, ribbed(makeLimb({{{0, 2.2, 0}, 0.2}, {{0.45, 2.17, -0.02}, 0.215}, {{0.82, 2.26, -0.05}, 0.25},
                                       {{1.02, 2.6, -0.08}, 0.265}, {{1.06, 3.1, -0.1}, 0.265}, {{1.03, 3.6, -0.1}, 0.24}}, 28),
                             6, 0.24, armEdge, 0.2));
  return body;
}

Pose bent(const Body& body, const Vec3& whole, const Vec3& left, const Vec3& right) {
  Pose pose(body);
  bend(pose, body, trunk, 0.08, 1.0, whole);
  bend(pose, body, leftArm, 0.2, 1, left);
  bend(pose, body, rightArm, 0.2, 1, right);
  return pose;
}

}  // namespace

Sample makeCactus() {
  const Body body = makeBody();
  const double degree = M_PI / 180;
  const std::vector<Pose> poses{
      bent(body, -95 * degree * Vec3::UnitZ(), {0, 0, -0.35}, {0, 0, -0.75}),
      Pose(body),
      bent(body, 85 * degree * Vec3::UnitX(), {0.5, 0, 0.35}, {0.7, 0, -0.3}),
  };
  return {"cactus", "Cactus", "A cactus bent to one side, upright, and bent towards you: the paper's first example.",
          BoundaryKind::Natural, posedKeyframes(body, poses, 0.5, 24)};
}

}  // namespace shapespline
