// A gymnast who swings both arms over more than half a turn: no pair of keys lies further apart than a quarter turn,
// the first and the last do.
#include <cmath>

#include "samples/rig.h"
#include "samples/sample.h"

namespace shapespline {
namespace {

// It looks along z; its left is +x.
enum GymnastPart { gymnastTrunk, gymnastHead, gymnastArm, otherArm, gymnastLeg, otherLeg };

constexpr double radians = M_PI / 180;
constexpr int gymnastKeys = 5;

// Out of the shoulder first, then down: the swing turns the short part beside the trunk.
Limb gymnastsArm(double side) {
  return makeLimb({{{0.15 * side, 1.555, 0}, 0.13},
                   {{0.37 * side, 1.58, 0}, 0.115},
                   {{0.47 * side, 1.46, 0}, 0.1},
                   {{0.5 * side, 1.12, 0}, 0.085},
                   {{0.52 * side, 0.84, 0.02}, 0.07},
                   {{0.52 * side, 0.68, 0.03}, 0.085}},
                  40, 0.036, 0.07);
}

Limb gymnastsLeg(double side) {
  return makeLimb({{{0.14 * side, 0.98, 0}, 0.17},
                   {{0.16 * side, 0.6, 0.01}, 0.13},
                   {{0.16 * side, 0.3, -0.01}, 0.105},
                   {{0.16 * side, 0.1, -0.01}, 0.085},
                   {{0.17 * side, 0.055, 0.12}, 0.075},
                   {{0.18 * side, 0.05, 0.2}, 0.06}},
                  36, 0.044, 0.08);
}

Body gymnastBody() {
  Body body;
  body.floor = 0;
  body.floorRounding = 0.03;
  Limb whole =
      makeLimb({{{0, 0.92, 0}, 0.22}, {{0, 1.18, 0}, 0.2}, {{0, 1.48, 0}, 0.25}, {{0, 1.62, 0}, 0.17}}, 24, 0.06, 0);
  whole.flattening = {Vec3::UnitZ(), 0.72};
  attach(body, -1, whole);
  attach(body, gymnastTrunk,
         makeLimb({{{0, 1.6, 0}, 0.095}, {{0, 1.76, 0.01}, 0.085}, {{0, 1.92, 0.03}, 0.15}, {{0, 2.02, 0.03}, 0.15}},
                  14, 0.038, 0.05));
  attach(body, gymnastTrunk, gymnastsArm(1));
  attach(body, gymnastTrunk, gymnastsArm(-1));
  attach(body, gymnastTrunk, gymnastsLeg(1));
  attach(body, gymnastTrunk, gymnastsLeg(-1));
  return body;
}

// A crouch by `knee` keeps the soles where they are: thigh and shin are about as long as each other.
void crouch(Pose& pose, const Body& body, double knee) {
  for (const int part : {gymnastLeg, otherLeg}) {
    bend(pose, body, part, 0, 0.16, Vec3(-knee / 2, 0, 0));
    bend(pose, body, part, 0.3, 0.5, Vec3(knee, 0, 0));
    bend(pose, body, part, 0.7, 0.84, Vec3(-knee / 2, 0, 0));
  }
  constexpr double thigh = 0.44;
  pose.root.pretranslate(Vec3(0, -2 * thigh * (1 - std::cos(knee / 2)), 0));
}

Pose swung(const Body& body, int key) {
  const double share = key / (gymnastKeys - 1.0);
  Pose pose(body);
  // From behind, over the front and the top, to behind again.
  const double swing = (35 - 205 * share) * radians;
  for (const int part : {gymnastArm, otherArm}) {
    bend(pose, body, part, 0.02, 0.4, Vec3(swing, 0, 0));
    bend(pose, body, part, 0.5, 0.68, Vec3(-(15 + 25 * std::sin(M_PI * share)) * radians, 0, 0));
  }
  const double lean = std::sin(2 * M_PI * share);
  bend(pose, body, gymnastTrunk, 0.1, 0.7, Vec3((10 * lean - 8 * (1 - share)) * radians + 0.16, 0, 0));
  bend(pose, body, gymnastHead, 0.1, 0.6, Vec3(-12 * lean * radians, 0, 0));
  const double knees[gymnastKeys] = {55, 70, 25, 5, 30};
  crouch(pose, body, knees[key] * radians);
  return pose;
}

}  // namespace

Sample makeGymnast() {
  const Body body = gymnastBody();
  std::vector<Pose> poses;
  for (int key = 0; key < gymnastKeys; ++key) poses.push_back(swung(body, key));
  return {"gymnast",
          "Gymnast",
          "Five poses of a swing: both arms turn by 205 degrees from the first to the last.",
          BoundaryKind::Natural,
          posedKeyframes(body, poses, 0.25, 22),
          0xb98a9a};
}

}  // namespace shapespline
