// Pins preserve the keys, the smoothness and the rigid invariance of the corrected motion.
#include <doctest/doctest.h>

#include "core/hold/pin_region.h"
#include "dense.h"
#include "pins.h"
#include "real_data.h"
#include "sequences.h"
#include "shapes.h"
#include "sweep.h"

namespace shapespline::test::pin_test {

namespace {

// A bar that bends to either side, with a pin at its end z = 10.
Keyframes swaying() { return keyframes(bar(), {bend(0), bend(0.9), bend(-0.5), bend(0.4)}, {0, 1, 2.5, 3.5}); }

int tip(const Keyframes& k) {
  int best = 0;
  for (std::size_t v = 0; v < k.keys[0].positions.size(); ++v)
    if (k.keys[0].positions[v].z() > k.keys[0].positions[best].z() + 1e-9) best = static_cast<int>(v);
  return best;
}

MotionOptions pinned(const Pin& pin) {
  MotionOptions motion;
  motion.pins = {pin};
  return motion;
}

Pin atTip(const Keyframes& k, int key = -1, std::vector<PathKey> path = {}) { return {tip(k), 0.08, key, path}; }

std::vector<PathKey> dragged() { return {{0.5, {0, 0.6, 0}}, {1.5, {0.2, -0.4, 0.1}}, {3, {0, 0.3, 0}}}; }

Sequence make(const Keyframes& k, const MotionOptions& motion = {}) { return sequenceOf(k, doublePrecision(), motion); }

}  // namespace

TEST_CASE("a fixed pin has its position in its key, and distant parts hardly move") {
  const Keyframes k = swaying();
  const Pin pin = atTip(k, 0);
  Sequence plain = make(k), s = make(k, pinned(pin));
  const Positions p = shapeAt(s, 1), q = shapeAt(plain, 1);
  const double way = (k.keys[0].positions[pin.vertex] - q[pin.vertex]).norm();
  const double left = (k.keys[0].positions[pin.vertex] - p[pin.vertex]).norm();
  MESSAGE("left of the way: " << 100 * left / way << " %; foot moves " << 100 * (p[0] - q[0]).norm() / way << " %");
  CHECK(left < 0.1 * way);
  CHECK((p[0] - q[0]).norm() < 0.1 * way);
  CHECK(largestDistance(shapeAt(s, 0), k.keys[0].positions) < 1e-7 * diagonalOf(k));
}

TEST_CASE("pins with and without holding, at every boundary: keys, smoothness, rigid motions, fading, purity") {
  const Keyframes k = swaying();
  const Mat3 r = expRotation(Vec3(0.3, -1, 2));
  Keyframes other = k;
  for (Key& key : other.keys)
    for (Vec3& p : key.positions) p = r * p + Vec3(4, -3, 9);
  std::vector<double> times;
  for (const Key& key : k.keys) times.push_back(key.time);
  std::vector<Map> turns;
  for (int j = 0; j < 4; ++j) turns.push_back(turn({1, 2, 0.5}, radians(100.0) * j, Vec3(j * j, 2 * j, 0)));
  const Keyframes rigid = keyframes(bar(), turns);
  for (const BoundaryKind boundary : {BoundaryKind::Natural, BoundaryKind::Hermite, BoundaryKind::Periodic})
    for (const bool hold : {true, false}) {
      CAPTURE(static_cast<int>(boundary));
      CAPTURE(hold);
      MotionOptions plain, motion;
      plain.boundary = motion.boundary = boundary;
      motion.hold = hold;
      motion.pins = {everyPin(k).front()};
      Sequence free = make(k, plain), exact = make(k, motion);
      for (const Key& key : k.keys)
        CHECK(largestDistance(shapeAt(exact, key.time), key.positions) < 1e-7 * diagonalOf(k));
      motion.pins = everyPin(k);
      Sequence s = make(k, motion);
      CHECK(largestDistance(shapeAt(s, 1.8), shapeAt(free, 1.8)) > 1e-3 * diagonalOf(k));
      const Sweep found = sweep(s);
      CHECK(found.growth <= 4);
      CHECK(found.zoomedStep <= std::max(1e-4, 3 * found.step * found.zoomedSpacing / found.spacing));
      CHECK(shapeAt(s, 1.3) == shapeAt(s, 1.3));
      REQUIRE(exact.update(motion, times).ok());
      CHECK(shapeAt(exact, 1.3) == shapeAt(s, 1.3));
      if (boundary != BoundaryKind::Periodic)
        for (const double t : {-1.0, -2.0, 4.5, 6.0}) CHECK(shapeAt(s, t) == shapeAt(free, t));

      MotionOptions moved = motion;
      for (Pin& pin : moved.pins)
        for (PathKey& key : pin.path) key.move = r * key.move;
      Sequence t = make(other, moved);
      for (const double time : {0.3, 1.7, 2.8}) {
        Positions expected = shapeAt(s, time);
        for (Vec3& p : expected) p = r * p + Vec3(4, -3, 9);
        CHECK(largestDistance(expected, shapeAt(t, time)) < 1e-5 * diagonalOf(k));
      }

      motion.pins = {everyPin(rigid).front()};
      Sequence turning = make(rigid, plain), held = make(rigid, motion);
      for (const double time : {0.1, 0.45, 0.8})
        CHECK(largestDistance(shapeAt(held, time), shapeAt(turning, time)) < 1e-6 * diagonalOf(rigid));
    }
}

TEST_CASE("a pin moves the parts of its body, but no other object") {
  // A hat on the pinned end, and a distant bar that nods independently.
  const Shape body = bar();
  const std::size_t hat = body.positions.size();
  const Shape dressed = joined(body, sphere({0, 0, 10.2}, 0.3));
  const std::size_t far = dressed.positions.size();
  const Shape all = joined(dressed, bar());
  Keyframes k;
  k.faces = all.faces;
  for (int j = 0; j < 4; ++j) {
    const Map bent = bend(std::vector{0.0, 0.9, -0.5, 0.4}[j], 10), nods = bend(0.3 * j, 10);
    k.keys.emplace_back();
    k.keys.back().time = j;
    for (std::size_t v = 0; v < all.positions.size(); ++v)
      k.keys.back().positions.push_back(v < far ? bent(all.positions[v])
                                                : nods(all.positions[v]) + Vec3(2.0 * j, 30, 0));
  }
  Keyframes bare = k;
  for (Key& key : bare.keys) key.positions.resize(hat);
  const Pin pin = {tip(bare), 0.02, 0};
  Sequence plain = make(k), s = make(k, pinned(pin));
  REQUIRE(plain.stats().components == 3);
  const Positions a = shapeAt(plain, 1.4), b = shapeAt(s, 1.4);
  double own = 0, object = 0;
  for (std::size_t v = 0; v < a.size(); ++v) {
    double& most = v < far ? own : object;
    most = std::max(most, (a[v] - b[v]).norm());
  }
  MESSAGE("the body is moved by " << own << ", the other object by " << object);
  CHECK(own > 0.01 * diagonalOf(k));
  CHECK(object < 1e-6 * diagonalOf(k));
  const auto gapIn = [&](const Positions& p) {
    Vec3 of = Vec3::Zero();
    for (std::size_t v = hat; v < far; ++v) of += p[v] / static_cast<double>(far - hat);
    double nearest = 1e300;
    for (std::size_t v = 0; v < hat; ++v) nearest = std::min(nearest, (p[v] - of).norm());
    return nearest;
  };
  MESSAGE("from the hat's middle to the body: " << gapIn(a) << ", pinned " << gapIn(b));
  CHECK(std::abs(gapIn(a) - gapIn(b)) < 0.1 * own);
}

TEST_CASE("a fixed pin moves along with a loop that moves on, without a seam") {
  Keyframes k = swaying();
  k.keys[3].positions = k.keys[0].positions;
  for (Vec3& p : k.keys[3].positions) p += Vec3(0, 2, 0);
  MotionOptions motion = pinned(atTip(k, 1, dragged()));
  motion.boundary = BoundaryKind::Periodic;
  Sequence s = make(k, motion);
  const Sweep found = sweep(s);
  CHECK(found.growth <= 4);
  CHECK(found.zoomedStep <= std::max(1e-4, 3 * found.step * found.zoomedSpacing / found.spacing));
  Positions next = shapeAt(s, 0.6);
  for (Vec3& p : next) p += Vec3(0, 2, 0);
  CHECK(largestDistance(next, shapeAt(s, 4.1)) < 1e-9 * diagonalOf(k));
}

TEST_CASE("patches do not spin where the shape moves far from held vertices") {
  Keyframes k = swaying();
  for (Vec3& p : k.keys[3].positions) p += Vec3(12, 0, 2.4);
  Sequence s = make(k, pinned({0, 0.08, 0}));
  CHECK(sweep(s, {20, 4, 8}).growth <= 4);
}

TEST_CASE("pins on real shapes: keys, rigid motions, fading, purity" * dense) {
  ImportOptions walk;
  walk.sampleCount = 6;
  walk.sampleAsked = true;
  const std::vector<std::string> cat = {"turns/cat/cat2.off", "turns/cat/cat5.off", "turns/cat/cat8.off"};
  const std::vector<std::pair<std::vector<std::string>, ImportOptions>> sets = {
      {cat, {}}, {lionPoses, {}}, {wolfPoses, {}}, {{"skin/CesiumMan.glb"}, walk}};
  for (const auto& [files, options] : sets) {
    if (!hasData(files)) continue;
    CAPTURE(files.front());
    const Keyframes k = realKeyframes(files, options);
    const double diagonal = diagonalOf(k);
    const double first = k.keys.front().time, second = k.keys[1].time, last = k.keys.back().time;
    MotionOptions own, every;
    own.pins = {everyPin(k).front()};
    every.pins = everyPin(k);
    Sequence plain = make(k), s = make(k, own);
    for (const Key& key : k.keys) CHECK(largestDistance(shapeAt(s, key.time), key.positions) < 1e-6 * diagonal);
    std::vector<double> times;
    for (const Key& key : k.keys) times.push_back(key.time);
    REQUIRE(s.update(every, times).ok());
    const double inside = 0.6 * first + 0.4 * second;
    const Positions here = shapeAt(s, inside);
    CHECK(largestDistance(here, shapeAt(plain, inside)) > 1e-3 * diagonal);
    shapeAt(s, last);
    CHECK(shapeAt(s, inside) == here);
    for (const double t : {first - (second - first), last + (last - k.keys[k.keyCount() - 2].time)})
      CHECK(shapeAt(s, t) == shapeAt(plain, t));

    const Mat3 r = expRotation(Vec3(0.3, -1, 2));
    const Vec3 away = diagonal * Vec3(0.4, -0.3, 0.9);
    Keyframes moved = k;
    for (Key& key : moved.keys)
      for (Vec3& p : key.positions) p = r * p + away;
    for (Pin& pin : every.pins)
      for (PathKey& key : pin.path) key.move = r * key.move;
    Sequence t = make(moved, every);
    Positions expected = here;
    for (Vec3& p : expected) p = r * p + away;
    CHECK(largestDistance(expected, shapeAt(t, inside)) < 1e-4 * diagonal);

    Keyframes rigid = k;
    rigid.keys.resize(4, rigid.keys[0]);
    for (int j = 0; j < 4; ++j) {
      rigid.keys[j].time = j;
      rigid.keys[j].positions = k.keys[0].positions;
      const Mat3 turned = expRotation(radians(100.0) * j * Vec3(1, 2, 0.5).normalized());
      for (Vec3& p : rigid.keys[j].positions) p = turned * p + diagonal * Vec3(j * j, 2 * j, 0);
    }
    Sequence turning = make(rigid), held = make(rigid, own);
    for (const double time : {0.3, 1.45})
      CHECK(largestDistance(shapeAt(held, time), shapeAt(turning, time)) < 1e-6 * diagonal);
  }
}

TEST_CASE("a pin on a vertex without faces has no effect, and one on a single vertex keeps its position") {
  Keyframes k = swaying();
  for (Key& key : k.keys) key.positions.push_back(Vec3(3, 0, 0));
  const int loose = static_cast<int>(k.keys[0].positions.size()) - 1;
  Sequence plain = make(k), none = make(k, pinned({loose, 0.05, 0})), one = make(k, pinned({tip(k), 1e-6, 0}));
  CHECK(largestDistance(shapeAt(none, 1), shapeAt(plain, 1)) < 1e-6 * diagonalOf(k));
  const Vec3 home = k.keys[0].positions[tip(k)];
  CHECK((shapeAt(one, 1)[tip(k)] - home).norm() < (shapeAt(plain, 1)[tip(k)] - home).norm());
}

TEST_CASE("invalid pins are refused") {
  const Keyframes k = swaying();
  for (const Pin& pin : {Pin{-1, 0.1}, Pin{1 << 20, 0.1}, Pin{0, -0.1}, Pin{0, 0.1, 4},
                         Pin{0, 0.1, -1, {{1, Vec3::Zero()}, {1, Vec3::Zero()}}}}) {
    auto s = Sequence::create(k, {}, pinned(pin));
    REQUIRE_FALSE(s.ok());
    CHECK(s.error().code == ErrorCode::InvalidOption);
  }
}

}  // namespace shapespline::test::pin_test
