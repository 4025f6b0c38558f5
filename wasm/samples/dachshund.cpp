// A dachshund's walk: eight keys of a cycle that closes, seen from a camera that walks along; and the same across the
// floor.
#include <cmath>

#include <Eigen/LU>

#include "samples/rig.h"
#include "samples/sample.h"

namespace shapespline {
namespace {

// It looks along x; left is -z.
enum BodyPart { torso, neck, head, jaw, tail, leftFore, rightFore, leftHind, rightHind, leftEar, rightEar };

constexpr int keyCount = 8;
constexpr double tau = 2 * M_PI;
constexpr double halfStride = 0.22, lift = 0.12, stance = 0.62;  // the share of the cycle that a paw stands

// Shares of a leg's length.
constexpr double wrist = 0.62, wristReach = 0.06;  // the paw turns over these
constexpr double pawStart = 0.84;

// A paw that stands still does so to the last vertex.
Limb withPaw(Limb leg) {
  leg.rigidFrom = pawStart;
  return leg;
}

Limb foreleg(double side) {
  return withPaw(makeLimb({{{0.98, 0.88, 0.20 * side}, 0.26},
                           {{0.90, 0.58, 0.29 * side}, 0.165},
                           {{0.97, 0.30, 0.29 * side}, 0.125},
                           {{1.02, 0.13, 0.29 * side}, 0.125},
                           {{1.17, 0.08, 0.30 * side}, 0.12}},
                          22, 0.06, 0.14));
}

Limb hindLeg(double side) {
  return withPaw(makeLimb({{{-1.13, 0.90, 0.17 * side}, 0.31},
                           {{-0.98, 0.58, 0.27 * side}, 0.20},
                           {{-1.22, 0.32, 0.28 * side}, 0.115},
                           {{-1.20, 0.13, 0.28 * side}, 0.12},
                           {{-1.04, 0.08, 0.29 * side}, 0.12}},
                          24, 0.06, 0.14));
}

Limb ear(double side) {
  Limb limb = makeLimb({{{1.72, 1.97, 0.19 * side}, 0.10},
                        {{1.66, 1.93, 0.32 * side}, 0.15},
                        {{1.62, 1.65, 0.40 * side}, 0.20},
                        {{1.66, 1.38, 0.41 * side}, 0.17}},
                       14, 0.048, 0.08);
  limb.flattening = {Vec3(0.15, 0.25, side).normalized(), 0.36};
  return limb;
}

Limb ball(const Vec3& centre, double radius, double edge) {
  return makeLimb({{centre - Vec3(0.01, 0, 0), radius}, {centre, radius}}, 2, edge, 0.02);
}

struct PlaneKnot {
  double x, y, radius;
};

// A limb in the plane of symmetry.
Limb inPlane(const std::vector<PlaneKnot>& shape, int joints, double edge, double blend) {
  std::vector<Knot> knots;
  for (const PlaneKnot& k : shape) knots.push_back({{k.x, k.y, 0}, k.radius});
  return makeLimb(knots, joints, edge, blend);
}

Body dachshundBody() {
  Body body;
  body.floor = 0;
  body.floorRounding = 0.05;
  attach(body, -1,
         inPlane({{-1.38, 0.90, 0.33}, {-0.9, 0.93, 0.375}, {-0.1, 0.88, 0.36}, {0.75, 0.88, 0.43}, {1.08, 0.98, 0.36}},
                 30, 0.096, 0));
  attach(body, torso, inPlane({{1.0, 1.02, 0.33}, {1.32, 1.36, 0.255}, {1.55, 1.68, 0.25}}, 14, 0.072, 0.12));
  attach(body, neck,
         inPlane({{1.60, 1.80, 0.27}, {1.83, 1.87, 0.29}, {2.10, 1.76, 0.185}, {2.40, 1.69, 0.15}, {2.62, 1.66, 0.13}},
                 20, 0.058, 0.12));
  attach(body, head, inPlane({{1.95, 1.67, 0.15}, {2.25, 1.565, 0.115}, {2.50, 1.53, 0.092}}, 8, 0.042, 0.035));
  attach(
      body, torso,
      inPlane({{-1.45, 1.0, 0.16}, {-1.85, 1.18, 0.105}, {-2.15, 1.52, 0.075}, {-2.24, 1.95, 0.05}}, 22, 0.05, 0.12));
  attach(body, torso, foreleg(-1));
  attach(body, torso, foreleg(1));
  attach(body, torso, hindLeg(-1));
  attach(body, torso, hindLeg(1));
  attach(body, head, ear(-1));
  attach(body, head, ear(1));
  for (double side : {-1.0, 1.0}) attach(body, head, ball({2.03, 1.94, 0.165 * side}, 0.075, 0.03));
  attach(body, head, ball({2.735, 1.73, 0}, 0.08, 0.034));
  return body;
}

struct Leg {
  BodyPart part;
  double phase;  ///< at which the paw touches down, as a share of the cycle
};

// The walk of most quadrupeds: hind, then fore of the same side, then the other side.
constexpr Leg legs[] = {{leftHind, 0}, {leftFore, 0.25}, {rightHind, 0.5}, {rightFore, 0.75}};

struct Placed {
  Vec3 place;
  Mat3 turn;
};

Placed pawOf(const Body& body, const Pose& pose, BodyPart leg) {
  const Limb& limb = body.limbs[leg];
  const int ankle = static_cast<int>(pawStart * (limb.jointCount() - 1));
  const Rigid placed = jointTransforms(body, pose)[body.firstJoint(leg) + limb.jointCount() - 1];
  return {placed * limb.centre[ankle], placed.linear()};
}

struct Step {
  double forward = 0, up = 0, pitch = 0;  ///< of the paw against its place at rest
};

Step stepAt(double phase) {
  phase -= std::floor(phase);
  if (phase < stance) return {halfStride * (1 - 2 * phase / stance), 0, 0};
  const double swing = (phase - stance) / (1 - stance);
  const double up = std::sin(M_PI * swing);
  return {-halfStride * std::cos(M_PI * swing), lift * up * up, -0.9 * up * up * (1 - 0.6 * swing)};
}

// shoulder: forward and outward.
void setLeg(Pose& pose, const Body& body, BodyPart leg, const Vec2& shoulder, double elbow, const Mat3& paw) {
  const int first = body.firstJoint(leg);
  for (int j = 0; j < body.limbs[leg].jointCount(); ++j) pose.turns[first + j].setZero();
  bend(pose, body, leg, 0, 0.2, {shoulder.y(), 0, shoulder.x()});
  bend(pose, body, leg, 0.3, wrist - wristReach, elbow * Vec3::UnitZ());
  // However the body turns above it, the paw does not.
  const Eigen::AngleAxisd back(pawOf(body, pose, leg).turn.transpose() * paw);
  bend(pose, body, leg, wrist - wristReach, wrist + wristReach, back.angle() * back.axis());
}

// Inverse kinematics: Newton's method on shoulder and elbow until the paw is where the step wants it.
void placePaw(Pose& pose, const Body& body, BodyPart leg, const Step& step) {
  const Vec3 target = pawOf(body, Pose(body), leg).place + Vec3(step.forward, step.up, 0);
  const Mat3 paw = Eigen::AngleAxisd(step.pitch, Vec3::UnitZ()).toRotationMatrix();
  Vec3 angles = Vec3::Zero();
  const auto miss = [&](const Vec3& a) -> Vec3 {
    setLeg(pose, body, leg, a.head<2>(), a.z(), paw);
    return pawOf(body, pose, leg).place - target;
  };
  for (int i = 0; i < 20; ++i) {
    constexpr double h = 1e-5;
    const Vec3 at = miss(angles);
    Mat3 jacobian;
    for (int k = 0; k < 3; ++k) jacobian.col(k) = (miss(angles + h * Vec3::Unit(k)) - at) / h;
    Vec3 change = -jacobian.fullPivLu().solve(at);
    if (change.norm() > 0.3) change *= 0.3 / change.norm();
    angles += change;
  }
  miss(angles);
}

Pose walkPose(const Body& body, double phase) {
  const auto wave = [&](double beats, double delay) { return std::sin(tau * (beats * phase - delay)); };
  Pose pose(body);
  const Vec3 spine(0.06 * wave(1, 0.2), 0.22 * wave(1, 0), 0.03 * wave(2, 0.3));
  bend(pose, body, torso, 0, 1, spine);
  // Half of the bend turns the chest, half the pelvis the other way.
  pose.root = Eigen::Translation3d(0, -0.07 + 0.015 * wave(2, 0.1), 0) *
              Eigen::AngleAxisd(-0.5 * spine.norm(), spine.normalized());
  bend(pose, body, neck, 0, 1, {0, -0.10 * wave(1, 0), 0.08 * wave(2, 0.35)});
  bend(pose, body, head, 0, 0.3, {0.06 * wave(1, 0.25), -0.05 * wave(1, 0.1), -0.06 * wave(2, 0.45)});
  bend(pose, body, tail, 0, 1, {0.5 * wave(1, 0.1), 0.55 * wave(1, 0.1), 0.1 * wave(2, 0)});
  for (BodyPart side : {leftEar, rightEar}) {
    const double out = side == leftEar ? 1 : -1;
    bend(pose, body, side, 0.1, 1, {out * (0.12 + 0.14 * wave(2, 0.6)), 0, 0.25 * wave(2, 0.7)});
  }
  for (const Leg& leg : legs) placePaw(pose, body, leg.part, stepAt(phase - leg.phase));
  return pose;
}

}  // namespace

Sample makeDachshund() {
  const Body body = dachshundBody();
  std::vector<Pose> poses;
  for (int j = 0; j < keyCount; ++j) poses.push_back(walkPose(body, double(j) / keyCount));
  return {"dachshund",
          "Dachshund",
          "Eight poses of a walk; the periodic spline closes the loop.",
          BoundaryKind::Periodic,
          posedKeyframes(body, poses, 1.0 / keyCount, 24),
          0xa9714b};
}

Sample makeStroll() {
  constexpr int cycles = 2, keysPerCycle = 4;
  constexpr double way = 2 * halfStride / stance;  // of a cycle
  const Body body = dachshundBody();
  std::vector<Pose> poses;
  for (int j = 0; j <= cycles * keysPerCycle; ++j) {
    const double phase = double(j) / keysPerCycle;
    Pose pose = walkPose(body, phase);
    pose.root = Eigen::Translation3d(way * (phase - 0.5 * cycles), 0, 0) * pose.root;
    poses.push_back(pose);
  }
  return {"stroll",
          "Stroll",
          "A dachshund crosses the floor in nine poses; what rests is held, so that its paws stay where they stand.",
          BoundaryKind::Natural,
          posedKeyframes(body, poses, 1.0 / keysPerCycle, 24),
          0xc08d5f,
          true};
}

}  // namespace shapespline
