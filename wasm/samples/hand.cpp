// A hand that counts from a fist to five.
#include "samples/rig.h"
#include "samples/sample.h"

namespace shapespline {
namespace {

// The palm looks along z, the thumb is at -x.
enum { palm, indexFinger, middleFinger, ringFinger, littleFinger, thumb };

constexpr double degree = M_PI / 180;

Limb finger(double x, double lean, double length, double radius) {
  const auto knot = [&](double along, double thickness) {
    return Knot{{x + lean * along, 1.42 + along, 0.02}, thickness};
  };
  return makeLimb({knot(0, radius), knot(0.36 * length, 1.04 * radius), knot(0.68 * length, 0.95 * radius),
                   knot(length, 0.8 * radius)},
                  34, 0.046, 0.1);
}

Body handBody() {
  Body body;
  body.floor = 0;
  body.floorRounding = 0.08;
  Limb whole = makeLimb({{{0.02, -0.3, 0}, 0.44}, {{0.02, 0.25, 0}, 0.42}, {{0, 0.8, 0}, 0.58}, {{0.02, 1.3, 0}, 0.67}},
                        20, 0.085, 0);
  whole.flattening = {Vec3::UnitZ(), 0.5};
  attach(body, -1, whole);
  attach(body, palm, finger(-0.53, -0.08, 1.5, 0.165));
  attach(body, palm, finger(-0.175, -0.02, 1.66, 0.17));
  attach(body, palm, finger(0.19, 0.04, 1.56, 0.163));
  attach(body, palm, finger(0.525, 0.12, 1.26, 0.143));
  attach(body, palm,
         makeLimb({{{-0.3, 0.55, 0.08}, 0.2},
                   {{-0.62, 0.85, 0.16}, 0.2},
                   {{-0.86, 1.2, 0.2}, 0.17},
                   {{-0.98, 1.55, 0.2}, 0.145}},
                  26, 0.048, 0.14));
  return body;
}

// How far each finger is closed, from 0, straight, to 1; the thumb last.
struct Closed {
  double fingers[5];
};

Pose posed(const Body& body, const Closed& closed) {
  Pose pose(body);
  for (int i = 0; i < 4; ++i) {
    const double share = closed.fingers[i];
    const double spread = (1 - share) * (i - 1.4) * -5 * degree;
    bend(pose, body, indexFinger + i, 0.3, 0.58, Vec3(48 * share * degree, 0, spread));
    bend(pose, body, indexFinger + i, 0.56, 0.8, Vec3(70 * share * degree, 0, 0));
    bend(pose, body, indexFinger + i, 0.78, 0.98, Vec3(28 * share * degree, 0, 0));
  }
  const double share = closed.fingers[4];
  bend(pose, body, thumb, 0.1, 0.6, Vec3(16 * degree, 26 * degree, -8 * degree) * share);
  bend(pose, body, thumb, 0.5, 0.95, Vec3(14 * degree, 14 * degree, -30 * degree) * share);
  return pose;
}

}  // namespace

Sample makeHand() {
  const Body body = handBody();
  const std::vector<Pose> poses{
      posed(body, {{1, 1, 1, 1, 0.6}}), posed(body, {{0, 1, 1, 1, 0.6}}), posed(body, {{0, 0, 1, 1, 0.6}}),
      posed(body, {{0, 0, 0, 1, 0.6}}), posed(body, {{0, 0, 0, 0, 0.6}}), posed(body, {{0, 0, 0, 0, 0}}),
  };
  return {"hand",
          "Hand",
          "A hand counts from a fist to five; every finger turns by 146 degrees and keeps its length.",
          BoundaryKind::Natural,
          posedKeyframes(body, poses, 0.4, 22),
          0xd9a584};
}

}  // namespace shapespline
