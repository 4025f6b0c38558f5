// Properties of every sequence (the method's exactness), one per test.
#include <doctest/doctest.h>

#include "core/mesh/measures.h"
#include "core/rotation/rigid_fit.h"
#include "kg_error.h"
#include "sequences.h"
#include "shapes.h"

namespace shapespline::test::invariants_test {

namespace {

Sequence make(const Keyframes& k, const EncodingOptions& encoding = doublePrecision(),
              const MotionOptions& motion = {}) {
  return sequenceOf(k, encoding, motion);
}

const std::vector<double> slider = {-0.4, -0.2, -0.05, 0.13, 0.3, 0.5, 0.62, 0.77, 0.9, 1.1, 1.4};

}  // namespace

TEST_CASE("keys are reproduced") {
  const Keyframes k = bentBar({0, 70, -50, 120});
  const double diagonal = diagonalOf(k);
  for (const Method method :
       {Method::Lri, Method::Geodesic, Method::Linear, Method::CubicVertex, Method::RotationStrain, Method::Rimd})
    for (const BoundaryKind boundary : {BoundaryKind::Natural, BoundaryKind::Hermite, BoundaryKind::Periodic})
      for (const Stretch stretch : {Stretch::Linear, Stretch::Log}) {
        CAPTURE(int(method));
        CAPTURE(int(boundary));
        CAPTURE(int(stretch));
        MotionOptions motion;
        motion.method = method;
        motion.boundary = boundary;
        EncodingOptions encoding = doublePrecision();
        encoding.stretch = stretch;
        encoding.reference = 1;
        Sequence inDouble = make(k, encoding, motion);
        encoding.precision = Precision::Single;
        Sequence inSingle = make(k, encoding, motion);
        for (const Key& key : k.keys) {
          CHECK(largestDistance(shapeAt(inDouble, key.time), key.positions) < 1e-9 * diagonal);
          Frame frame;
          REQUIRE(inSingle.evaluate(key.time, frame).ok());
          CHECK(largestDistance(toPositions(frame.positions), key.positions) < 1e-5 * diagonal);
        }
      }
}

TEST_CASE("single precision stays close to double between the keys") {
  const Keyframes k = bentBar({0, 70, -50, 120});
  Sequence inDouble = make(k), inSingle = make(k, {});
  for (double t : slider) {
    Frame frame;
    REQUIRE(inSingle.evaluate(t, frame).ok());
    CHECK(largestDistance(toPositions(frame.positions), shapeAt(inDouble, t)) < 1e-5 * diagonalOf(k));
  }
}

TEST_CASE("a common rigid motion of all keys moves the whole sequence") {
  const Keyframes k = bentBar({0, 80, 20});
  const Map move = turn(Vec3(1, 2, -0.5), 2.2, Vec3(3, -7, 11));
  Keyframes moved = k;
  for (Key& key : moved.keys) key.positions = mapped(key.positions, move);
  for (const BoundaryKind boundary : {BoundaryKind::Natural, BoundaryKind::Periodic}) {
    MotionOptions motion;
    motion.boundary = boundary;
    Sequence a = make(k, doublePrecision(), motion), b = make(moved, doublePrecision(), motion);
    for (double t : slider) CHECK(largestDistance(mapped(shapeAt(a, t), move), shapeAt(b, t)) < 1e-8 * diagonalOf(k));
  }
}

TEST_CASE("moving one key rigidly changes only the global motion") {
  Keyframes k = bentBar({0, 80, 20});
  Sequence a = make(k);
  k.keys[1].positions = mapped(k.keys[1].positions, turn(Vec3(0, 1, 1), 1.1, Vec3(5, 0, 0)));
  Sequence b = make(k);
  for (double t : slider) {
    const Positions x = shapeAt(a, t), y = shapeAt(b, t);
    CHECK(largestDistance(aligned(x, y), y) < 1e-8 * diagonalOf(k));
  }
}

TEST_CASE("two keys with natural boundary give the geodesic") {
  const Keyframes k = bentBar({10, 130});
  MotionOptions geodesic;
  geodesic.method = Method::Geodesic;
  Sequence a = make(k), b = make(k, doublePrecision(), geodesic);
  for (double t : slider) CHECK(largestDistance(shapeAt(a, t), shapeAt(b, t)) < 1e-10 * diagonalOf(k));
}

TEST_CASE("rigid turns stay rigid") {
  const Shape shape = bar();
  const Vec3 axis(0.3, 1, 0.2);
  const Keyframes k = keyframes(
      shape, {turn(axis, 0), turn(axis, radians(100), Vec3(1, 0, 0)), turn(axis, radians(200), Vec3(0, 3, 0))});
  Sequence s = make(k);
  for (double t : slider) CHECK(fitRigid(shape.positions, shapeAt(s, t)).largestDistance < 1e-9 * diagonalOf(k));
  // The sections turn evenly about the axis: 50 degrees after a quarter.
  CHECK(largestDistance(aligned(mapped(shape.positions, turn(axis, radians(50))), shapeAt(s, 0.25)), shapeAt(s, 0.25)) <
        1e-9 * 10);
  const Positions quarter = shapeAt(s, 0.25);
  const Mat3 r = fitRigid(shape.positions, quarter).rotation;
  CHECK(logRotation(r).norm() == doctest::Approx(radians(50)).epsilon(1e-6));
}

TEST_CASE("a mesh of several parts stays rigid under a rigid turn") {
  const Shape parts = joined(joined(bar(), sphere({1.2, 0, 5}, 0.4)), sphere({0, 1.5, 9}, 0.3));
  const Vec3 axis(0, 1, 0.3);
  const Keyframes k = keyframes(parts, {turn(axis, 0), turn(axis, radians(80)), turn(axis, radians(160))});
  Sequence s = make(k);
  CHECK(s.stats().components == 3);
  for (double t : slider) CHECK(fitRigid(parts.positions, shapeAt(s, t)).largestDistance < 1e-6 * diagonalOf(k));
}

TEST_CASE("a twisted bar follows the analytic twist within KG 1.5") {
  const Keyframes k = twistedBar({0, 180, 350});
  Sequence s = make(k);
  std::vector<Positions> exact, ours;
  for (int i = 0; i <= 40; ++i) {
    const double t = i / 40.0;
    // The twist angle is the natural spline through 0, 180, 350 degrees: m'' = 0 at the ends.
    const double a = 0, b = 180, c = 350;
    const double second = 3 * (c - 2 * b + a) / (2 * 0.25);  // m''(0.5) with h = 0.5
    const double u = t < 0.5 ? t / 0.5 : (1 - t) / 0.5, end = t < 0.5 ? a : c;
    const double angle = end + (b - end) * u + second * 0.25 / 6 * (u * u * u - u);
    exact.push_back(mapped(bar().positions, twist(radians(angle))));
    ours.push_back(aligned(shapeAt(s, t), exact.back()));
  }
  const double error = kgError(exact, ours, KgCentre::SequenceAverage);
  MESSAGE("KG " << error);
  CHECK(error < 1.5);
}

TEST_CASE("a bend keeps its volume, unlike a linear blend") {
  for (const auto& [bendDegrees, share] : {std::pair{120.0, 0.99}, std::pair{340.0, 0.96}}) {
    const double degrees = bendDegrees;
    const Keyframes k = bentBar({0, degrees});
    MotionOptions linear;
    linear.method = Method::Linear;
    Sequence s = make(k), l = make(k, doublePrecision(), linear);
    const double keys =
        (enclosedVolume(k.keys[0].positions, k.faces) + enclosedVolume(k.keys[1].positions, k.faces)) / 2;
    const double ours = enclosedVolume(shapeAt(s, 0.5), k.faces) / keys,
                 blend = enclosedVolume(shapeAt(l, 0.5), k.faces) / keys;
    MESSAGE("bend by " << degrees << " degrees, halfway volume: LRI " << 100 * ours << " %, linear blend "
                       << 100 * blend << " %");
    CHECK(ours >= share);
    CHECK(blend < ours);
  }
}

namespace {

void checkHalfway(const Keyframes& k) {
  Sequence s = make(k);
  const Positions& rest = k.keys[0].positions;
  const auto half = sectionTurns(rest, shapeAt(s, 0.5), 4), whole = sectionTurns(rest, k.keys[1].positions, 4);
  REQUIRE(half.size() == whole.size());
  for (std::size_t i = 0; i < half.size(); ++i)
    CHECK(half[i].norm() == doctest::Approx(whole[i].norm() / 2).epsilon(0.02));
}

}  // namespace

TEST_CASE("a twist by 720 degrees is halfway a twist by 360") { checkHalfway(twistedBar({0, 720})); }
TEST_CASE("a bend by 540 degrees is halfway a bend by 270") { checkHalfway(bentBar({0, 540})); }

TEST_CASE("no vertex jumps between neighbouring times") {
  for (const Keyframes& k : {twistedBar({0, 180, 350}), bentBar({0, 120, -60, 200}), twistedBar({0, 720})}) {
    for (const BoundaryKind boundary : {BoundaryKind::Natural, BoundaryKind::Periodic}) {
      MotionOptions motion;
      motion.boundary = boundary;
      Sequence s = make(k, {}, motion);
      Frame frame;
      std::vector<float> before;
      double largest = 0;
      for (int i = -400; i <= 1400; ++i) {
        REQUIRE(s.evaluate(i / 1000.0, frame).ok());
        for (std::size_t c = 0; c < before.size(); ++c)
          largest = std::max(largest, double(std::abs(frame.positions[c] - before[c])));
        before = frame.positions;
      }
      CHECK(largest < 0.02 * diagonalOf(k));
    }
  }
}

TEST_CASE("the second derivative is continuous across keys") {
  const Keyframes k = bentBar({0, 70, -50, 120});
  Sequence s = make(k);
  const double h = 1e-4;
  for (int j = 1; j <= 2; ++j) {
    const double t = k.keys[j].time;
    const auto second = [&](double centre) {
      const Positions a = shapeAt(s, centre - h), b = shapeAt(s, centre), c = shapeAt(s, centre + h);
      Positions d(a.size());
      for (std::size_t v = 0; v < a.size(); ++v) d[v] = (a[v] - 2 * b[v] + c[v]) / (h * h);
      return d;
    };
    const Positions before = second(t - h), after = second(t + h);
    double scale = 0;
    for (const Vec3& d : before) scale = std::max(scale, d.norm());
    CHECK(largestDistance(before, after) < 0.02 * scale);
  }
}

TEST_CASE("a sphere beside a bending bar keeps its distance") {
  const double radius = 0.25, gap = 0.1;
  const Shape body = bar(), ball = sphere({0.5 + gap + radius, 0, 5}, radius);
  const Shape both = joined(body, ball);
  const auto map = [&](double degrees) -> Map {
    const Map bending = bend(radians(degrees));
    // The ball moves rigidly with the bar's surface at z = 5.
    const double a = radians(degrees) / 2;
    const Vec3 foot(0.5, 0, 5);
    const Map ballTurn = turn(Vec3::UnitY(), a);
    return [=](const Vec3& p) -> Vec3 {
      if ((p - Vec3(0.5 + gap + radius, 0, 5)).norm() <= radius * 1.001)
        return bending(foot) + ballTurn(Vec3(p - foot));
      return bending(p);
    };
  };
  const Keyframes k = keyframes(both, {map(0), map(60), map(120)});
  Sequence s = make(k);
  const auto distance = [&](const Positions& p) {
    double least = 1e9;
    for (std::size_t v = body.positions.size(); v < p.size(); ++v)
      for (std::size_t u = 0; u < body.positions.size(); ++u) least = std::min(least, (p[v] - p[u]).norm());
    return least;
  };
  const double rest = distance(k.keys[0].positions);
  for (double t : slider) CHECK(std::abs(distance(shapeAt(s, t)) - rest) < 0.02 * 2 * radius);
}

TEST_CASE("evaluate is a pure function of its arguments") {
  const Keyframes k = bentBar({0, 70, -50, 120});
  Sequence s = make(k, {});
  Frame first, again, other;
  REQUIRE(s.evaluate(0.37, first).ok());
  for (double t : slider) REQUIRE(s.evaluate(t, other).ok());
  MotionOptions motion;
  motion.boundary = BoundaryKind::Periodic;
  REQUIRE(s.update(motion, {0, 0.1, 0.5, 1}).ok());
  REQUIRE(s.evaluate(0.8, other).ok());
  REQUIRE(s.update({}, evenTimes(4)).ok());
  REQUIRE(s.evaluate(0.37, again).ok());
  CHECK(first.positions == again.positions);
  CHECK(first.normals == again.normals);
}

TEST_CASE("nothing is encoded or factored again while scrubbing, toggling and moving key times") {
  Sequence s = make(bentBar({0, 70, -50, 120}), {});
  const SequenceStats before = s.stats();
  Frame frame;
  for (const BoundaryKind boundary : {BoundaryKind::Natural, BoundaryKind::Hermite, BoundaryKind::Periodic}) {
    MotionOptions motion;
    motion.boundary = boundary;
    REQUIRE(s.update(motion, {0, 0.2, 0.7, 1.5}).ok());
    for (double t : slider) REQUIRE(s.evaluate(t, frame).ok());
  }
  // Recomputing would have taken a different time.
  CHECK(s.stats().encodeMs == before.encodeMs);
  CHECK(s.stats().factorMs == before.factorMs);
  CHECK(s.stats().solves == before.solves + 3 * static_cast<long long>(slider.size()));
}

}  // namespace shapespline::test::invariants_test
