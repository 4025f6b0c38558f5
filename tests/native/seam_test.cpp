// Periodic motions have no beginning. They are smooth at the closing point and do not depend on which key is first.
// Each further period adds the rigid motion from the first key to the last.
#include <doctest/doctest.h>

#include "one_sided.h"

namespace shapespline::test::seam_test {

namespace {

MotionOptions periodic(std::optional<double> period = {}) {
  MotionOptions motion;
  motion.boundary = BoundaryKind::Periodic;
  motion.period = period;
  return motion;
}

// A box in four positions, rotated about three axes in between. With a period of 4, it returns during the closing
// interval. Without a period, the rigid box continues from the last position as from the first.
Keyframes turnedBox(const std::vector<double>& times = {0, 1, 2, 3}) {
  return keyframes(box(1, 2, 3, 3, 5, 8),
                   {turn(Vec3::UnitX(), 0), turn(Vec3::UnitX(), radians(80), {2, 0, 0}),
                    turn(Vec3::UnitY(), radians(85), {2, 1, 1}), turn(Vec3::UnitZ(), radians(75), {0, 1, 0})},
                   times);
}

Map boxGoesOn() { return turn(Vec3::UnitZ(), radians(75), {0, 1, 0}); }

// A bar with similar rotations that also bends and must return.
Keyframes turnedBar(const std::vector<double>& times = {0, 1, 2, 3}) {
  const auto pose = [](double bending, const Map& place) -> Map {
    const Map bent = bend(radians(bending));
    return [=](const Vec3& p) -> Vec3 { return place(bent(p)); };
  };
  return keyframes(box(1, 1, 10, 3, 3, 20),
                   {pose(0, turn(Vec3::UnitX(), 0)), pose(60, turn(Vec3::UnitX(), radians(80))),
                    pose(-30, turn(Vec3::UnitY(), radians(85))), pose(90, turn(Vec3::UnitZ(), radians(75)))},
                   times);
}

// Moves once around the z axis by `degrees` per period, at a distance of 10, while bending as defined by `bending`.
Map alongCircle(double degrees) { return turn(Vec3::UnitZ(), radians(degrees)); }

Keyframes circleWalk(double degrees, const std::vector<double>& bending) {
  std::vector<Map> maps;
  const int steps = static_cast<int>(bending.size()) - 1;
  for (int j = 0; j <= steps; ++j) {
    const Map bent = bend(radians(bending[j])), place = alongCircle(degrees * j / steps);
    maps.push_back([=](const Vec3& p) -> Vec3 { return place(bent(p) + Vec3(10, 0, 0)); });
  }
  return keyframes(box(1, 1, 3, 3, 3, 8), maps, [&] {
    std::vector<double> times;
    for (int j = 0; j <= steps; ++j) times.push_back(j);
    return times;
  }());
}

// Four separate boxes, each hinged to the previous one about axes of its own.
Keyframes chain(const std::vector<std::array<double, 3>>& degrees, const std::vector<double>& times) {
  constexpr double length = 3, gap = 0.05;
  const Shape link = box(1, 0.8, length - gap, 3, 3, 6);
  Shape all;
  for (int i = 0; i < 4; ++i) {
    Shape next = link;
    next.positions =
        mapped(next.positions, [&](const Vec3& p) -> Vec3 { return p * (1 - 0.1 * i) + Vec3(0, 0, length * i); });
    all = i == 0 ? next : joined(all, next);
  }
  const std::array<Vec3, 3> axis = {Vec3::UnitX(), Vec3(1, 1, 0), Vec3(0, 1, 1)};
  std::vector<Map> maps;
  for (const auto& pose : degrees)
    maps.push_back([=](const Vec3& p) -> Vec3 {
      Vec3 q = p;
      for (int hinge = std::min(3, static_cast<int>(std::floor(p.z() / length))); hinge > 0; --hinge) {
        const Vec3 at(0, 0, length * hinge);
        q = at + expRotation(axis[hinge - 1].normalized() * radians(pose[hinge - 1])) * (q - at);
      }
      return q;
    });
  return keyframes(all, maps, times);
}

Keyframes swingingChain() {
  return chain({{0, 0, 0}, {50, -70, 90}, {-40, 60, 120}, {80, 20, -30}, {0, 0, 0}}, {0, 1, 1.7, 3, 4});
}

struct Walk {
  std::string name;
  double degrees;  // per period
  Keyframes keyframes;
};

std::vector<Walk> walks() {
  return {{"a circle in four quarters", 360, circleWalk(360, {0, 40, 0, -40, 0})},
          {"a sixth of a circle", 60, circleWalk(60, {0, 40, -40, 0})},
          {"a third of a circle, rigid", 120, circleWalk(120, {0, 0, 0, 0})}};
}

void checkSeam(const std::string& what, const Keyframes& k, const MotionOptions& motion) {
  CAPTURE(what);
  Sequence sequence = sequenceOf(k, doublePrecision(), motion);
  const PatchTurning patches(sequence);
  for (const double seam : {sequence.range().first, sequence.range().second}) {
    CAPTURE(seam);
    const Jumps jumps = jumpsAt(sequence, patches, seam);
    CHECK(jumps.angularVelocity <= 1e-3);
    CHECK(jumps.velocity <= 1e-3);
    CHECK(jumps.angularAcceleration <= 1e-2);
    CHECK(jumps.acceleration <= 1e-2);
  }
}

// Starts the loop with key `first`. The earlier keys follow the last one, `again` later and transformed by `next`. If
// the last key repeats the first, it is replaced by a copy of the new first key.
Keyframes startedAt(const Keyframes& k, int first, double period, const Map& next, bool lastIsFirst) {
  Keyframes out;
  out.faces = k.faces;
  const int distinct = k.keyCount() - (lastIsFirst ? 1 : 0), count = k.keyCount();
  for (int i = 0; i < count; ++i) {
    Key key = k.keys[(first + i) % distinct];
    if (first + i >= distinct) key.time += period, key.positions = mapped(key.positions, next);
    out.keys.push_back(key);
  }
  return out;
}

void checkSameLoop(const std::string& what, const Keyframes& k, const MotionOptions& motion, const Map& next,
                   bool lastIsFirst) {
  CAPTURE(what);
  Sequence sequence = sequenceOf(k, doublePrecision(), motion);
  const auto [start, end] = sequence.range();
  const int distinct = k.keyCount() - (lastIsFirst ? 1 : 0);
  for (int first = 1; first < distinct; ++first) {
    CAPTURE(first);
    EncodingOptions encoding = doublePrecision();
    encoding.reference = distinct - first;  // the original first key
    MotionOptions same = motion;
    if (!lastIsFirst) same.period = end - start;
    Sequence other = sequenceOf(startedAt(k, first, end - start, next, lastIsFirst), encoding, same);
    double largest = 0;
    for (int i = 0; i <= 24; ++i) {
      const double t = start + (end - start) * (i + 0.3) / 12;
      largest = std::max(largest, largestDistance(shapeAt(sequence, t), shapeAt(other, t)));
    }
    CHECK(largest < 2e-6 * diagonalOf(k));
  }
}

const Map unmoved = [](const Vec3& p) -> Vec3 { return p; };

}  // namespace

TEST_CASE("seam: velocities and accelerations do not jump where a loop closes") {
  checkSeam("a box about three axes", turnedBox(), periodic(4));
  checkSeam("a box about three axes that goes on", turnedBox(), periodic());
  checkSeam("a bar about three axes", turnedBar(), periodic());
  checkSeam("a bar about three axes, uneven times", turnedBar({0, 0.7, 2, 2.5}), periodic(4.2));
  checkSeam("a bar that bends", keyframes(bar(), {bend(0), bend(1), bend(-0.5)}, {0, 1, 2}), periodic());
  checkSeam("a chain of four components", swingingChain(), periodic());
  for (const Walk& walk : walks()) checkSeam(walk.name, walk.keyframes, periodic());
}

TEST_CASE("seam: starting with another key gives the same loop") {
  checkSameLoop("a box about three axes", turnedBox(), periodic(4), unmoved, false);
  checkSameLoop("a box about three axes that goes on", turnedBox(), periodic(), boxGoesOn(), true);
  checkSameLoop("a bar about three axes", turnedBar(), periodic(), unmoved, false);
  checkSameLoop("a bar about three axes, uneven times", turnedBar({0, 0.7, 2, 2.5}), periodic(4.2), unmoved, false);
  checkSameLoop("a chain of four components", swingingChain(), periodic(), unmoved, true);
  for (const Walk& walk : walks())
    checkSameLoop(walk.name, walk.keyframes, periodic(), alongCircle(walk.degrees), true);
}

TEST_CASE("seam: a loop that ends turned says what its export does, unless it stays in place") {
  const auto angleOf = [](const Keyframes& keys, bool inPlace) {
    MotionOptions motion = periodic();
    motion.inPlace = inPlace;
    std::string found;
    const Sequence sequence = sequenceOf(keys, doublePrecision(), motion);
    for (const Warning& w : sequence.warnings())
      if (w.code == "loop-turns") found = w.message.substr(0, w.message.find(" from its start"));
    return found;
  };
  const Vec3 up(0, 1, 0);
  const Keyframes spin = keyframes(bar(), {unmoved, turn(up, radians(100)), turn(up, radians(200))});
  CHECK(angleOf(spin, false) == "Each period of the loop ends 160 degrees");
  CHECK(angleOf(spin, true).empty());
  CHECK(angleOf(keyframes(bar(), {unmoved, bend(1), turn(up, 0, Vec3(5, 0, 0))}), false).empty());
}

TEST_CASE("seam: one more period of a walk adds its rigid motion once more, in every method") {
  for (const Walk& walk : walks())
    for (const Method method :
         {Method::Lri, Method::RotationStrain, Method::Rimd, Method::Linear, Method::CubicVertex}) {
      CAPTURE(walk.name);
      CAPTURE(int(method));
      MotionOptions motion = periodic();
      motion.method = method;
      Sequence sequence = sequenceOf(walk.keyframes, doublePrecision(), motion);
      const double period = sequence.range().second - sequence.range().first, diagonal = diagonalOf(walk.keyframes);
      for (const int periods : {1, 2, 5, -3})
        for (const double t : {0.0, 0.4, 1.5, period - 0.1}) {
          CAPTURE(periods);
          CAPTURE(t);
          const Positions expected = mapped(shapeAt(sequence, t), alongCircle(periods * walk.degrees));
          const double off = largestDistance(expected, shapeAt(sequence, t + periods * period)) / diagonal;
          CHECK(off < (method == Method::RotationStrain ? 1e-9 : method == Method::Lri ? 1e-8 : 1e-6));
        }
      if (method == Method::RotationStrain) CHECK(sweep(sequence).growth < 2);
      const Positions end = shapeAt(sequence, period - 1e-9);
      CHECK(largestDistance(end, walk.keyframes.keys.back().positions) < 1e-6 * diagonal);
      CHECK(largestDistance(end, shapeAt(sequence, period + 1e-9)) < 1e-6 * diagonal);
    }
}

}  // namespace shapespline::test::seam_test
