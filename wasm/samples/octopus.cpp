// An octopus whose arms curl by more than half a turn: resting, lifting its arms, curling them up, whirling.
#include <cmath>

#include "samples/rig.h"
#include "samples/sample.h"

namespace shapespline {
namespace {

constexpr int armCount = 8;
enum { mantle, firstArm };

Vec3 outwards(int arm) {
  const double azimuth = 2 * M_PI * (arm + 0.5) / armCount;
  return {std::cos(azimuth), 0, std::sin(azimuth)};
}

Limb arm(const Vec3& out) {
  const auto knot = [&](double away, double up, double radius) {
    return Knot{away * out + up * Vec3::UnitY(), radius};
  };
  return makeLimb({knot(0.12, 0.62, 0.24), knot(0.5, 0.46, 0.225), knot(1.0, 0.26, 0.185), knot(1.7, 0.17, 0.135),
                   knot(2.4, 0.12, 0.09), knot(2.95, 0.10, 0.055)},
                  40, 0.078, 0.2);
}

Body octopusBody() {
  Body body;
  attach(body, -1,
         makeLimb({{{0, 0.62, 0}, 0.34}, {{-0.05, 1.02, 0}, 0.44}, {{-0.28, 1.5, 0}, 0.60}, {{-0.52, 1.82, 0}, 0.52}},
                  16, 0.11, 0));
  for (int i = 0; i < armCount; ++i) attach(body, mantle, arm(outwards(i)));
  for (double side : {-1.0, 1.0}) {
    attach(body, mantle,
           makeLimb({{{0.12, 1.12, 0.26 * side}, 0.16}, {{0.22, 1.19, 0.34 * side}, 0.14}}, 2, 0.055, 0.05));
  }
  return body;
}

// Turns of an arm, in radians: up at its root, up along its outer part, and sideways along all of it.
struct ArmBend {
  double lift, curl, swing;
};

void bendArm(Pose& pose, const Body& body, int arm, const ArmBend& turns) {
  const Vec3 up = outwards(arm).cross(Vec3::UnitY());
  bend(pose, body, firstArm + arm, 0.05, 0.4, turns.lift * up);
  bend(pose, body, firstArm + arm, 0.35, 1.0, turns.curl * up);
  bend(pose, body, firstArm + arm, 0.15, 1.0, turns.swing * Vec3::UnitY());
}

Pose posed(const Body& body, const Vec3& lean, double height, ArmBend (*bendOf)(int arm)) {
  Pose pose(body);
  pose.root.translate(Vec3(0, height, 0));
  bend(pose, body, mantle, 0.2, 1, lean);
  for (int i = 0; i < armCount; ++i) bendArm(pose, body, i, bendOf(i));
  return pose;
}

double sign(int arm) { return arm % 2 == 0 ? 1 : -1; }

// No two arms do the same: a number in [-1, 1] that differs from arm to arm.
double own(int arm) { return std::sin(2.4 * arm + 0.5); }

}  // namespace

Sample makeOctopus() {
  const Body body = octopusBody();
  const std::vector<Pose> poses{
      posed(body, {0, 0, 0.1}, 0, [](int i) { return ArmBend{0.1, 0.2 + 0.25 * own(i), 0.55 * sign(i)}; }),
      posed(body, {0, 0, -0.25}, 0.1,
            [](int i) { return ArmBend{0.45 + 0.2 * own(i), -1.1 - 0.9 * own(i), -0.45 * sign(i)}; }),
      posed(body, {0, 0, 0.3}, 0.45, [](int i) { return ArmBend{-0.3 + 0.15 * own(i), 3.5 + 0.6 * own(i), 0.15}; }),
      posed(body, {0, 0.5, 0}, 0.15, [](int i) { return ArmBend{0.2 + 0.15 * own(i), 0.5 + 0.3 * own(i), 2.1}; }),
  };
  return {"octopus",
          "Octopus",
          "Eight arms curl and whirl through four poses; every turn adds up along the arm.",
          BoundaryKind::Natural,
          posedKeyframes(body, poses, 0.5, 10),
          0xc8785f};
}

}  // namespace shapespline
