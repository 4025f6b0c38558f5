// A saguaro: a ribbed trunk with two arms, bent one way, upright, and bent in the orthogonal plane (paper Fig. 1).
#include "samples/rig.h"
#include "samples/sample.h"

namespace shapespline {
namespace {

constexpr double trunkEdge = 0.05, armEdge = 0.0435;  // seven to a rib
enum { trunk, leftArm, rightArm };

Limb ribbed(Limb limb, int ribs, double depth, double edge, double blend) {
  limb.edge = edge;
  limb.ribs = {ribs, depth};
  limb.blend = blend;
  return limb;
}

struct ArmKnot {
  double away, up, radius;  // from where the arm leaves the trunk
};

Limb arm(const Vec3& direction, double height, const std::vector<ArmKnot>& shape) {
  const Vec3 root(0, height, 0);
  std::vector<Knot> knots{{root, shape.front().radius - 0.015}};
  for (const ArmKnot& k : shape) {
    knots.push_back({root + k.away * direction.normalized() + k.up * Vec3::UnitY(), k.radius});
  }
  return ribbed(makeLimb(knots, 29), 6, 0.24, armEdge, 0.2);
}

Body cactusBody() {
  Body body;
  body.floor = 0;
  body.floorRounding = 0.12;
  attach(body, -1,
         ribbed(makeLimb({{{0, 0, 0}, 0.54},
                          {{0, 0.55, 0}, 0.44},
                          {{0, 1.9, 0}, 0.47},
                          {{0, 3.4, 0}, 0.475},
                          {{0, 4.35, 0}, 0.43}},
                         46),
                9, 0.26, trunkEdge, 0));
  attach(body, trunk,
         arm({-0.97, 0, 0.22}, 1.55,
             {{0.5, -0.03, 0.235}, {0.93, 0.07, 0.27}, {1.19, 0.45, 0.29}, {1.26, 1.05, 0.295}, {1.23, 1.65, 0.265}}));
  attach(body, trunk,
         arm({0.90, 0, -0.44}, 2.2,
             {{0.45, -0.03, 0.215}, {0.83, 0.06, 0.25}, {1.04, 0.4, 0.265}, {1.09, 0.85, 0.265}, {1.07, 1.3, 0.24}}));
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
  const Body body = cactusBody();
  const double degree = M_PI / 180;
  const std::vector<Pose> poses{
      bent(body, -85 * degree * Vec3::UnitZ(), {0, 0, -0.3}, {0, 0.45, -0.55}),
      Pose(body),
      bent(body, 80 * degree * Vec3::UnitX(), {0.35, 0.2, 0.3}, {0.6, 0, -0.3}),
  };
  return {"cactus",
          "Cactus",
          "A cactus bent to one side, upright, and bent towards you: the paper's first example.",
          BoundaryKind::Natural,
          posedKeyframes(body, poses, 0.5, 32),
          0x86a263};
}

}  // namespace shapespline
