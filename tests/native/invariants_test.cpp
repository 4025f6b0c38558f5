// Properties of every sequence (the method's exactness), one per test.
#include <doctest/doctest.h>

#include "core/mesh/measures.h"
#include "core/rotation/rigid_fit.h"
#include "kg_error.h"
#include "sequences.h"
#include "shapes.h"

namespace shapespline::test::invariants_test {

namespace {

const std::vector<double> slider = {-0.4, -0.2, -0.05, 0.13, 0.3, 0.5, 0.62, 0.77, 0.9, 1.1, 1.4};

EncodingOptions ghostly(int faces, Transfer transfer = Transfer::Exact) {
  EncodingOptions options = doublePrecision();
  options.ghostFaces = faces;
  options.transfer = transfer;
  return options;
}

/// The bar 1 x 1 x 10, much finer than a ghost of 1000 faces.
Shape fineBar() { return box(1, 1, 10, 8, 8, 80); }

/// How a bar moves: by its own faces or those of a ghost mesh.
struct Space {
  const char* name;
  EncodingOptions encoding;
  Shape bar;
  int sectionsPerUnit;

  bool hasGhost() const { return encoding.ghostFaces > 0; }
};

std::vector<Space> spaces(int ghostFaces = 1000) {
  return {{"all faces", doublePrecision(), bar(), 4},
          {"a ghost mesh", ghostly(ghostFaces), fineBar(), 8},
          {"a ghost mesh as published", ghostly(ghostFaces, Transfer::Paper), fineBar(), 8}};
}

Sequence make(const Keyframes& k, const EncodingOptions& encoding = doublePrecision(),
              const MotionOptions& motion = {}) {
  return sequenceOf(k, encoding, motion);
}

MotionOptions motionBy(Method method, BoundaryKind boundary = BoundaryKind::Natural) {
  MotionOptions motion;
  motion.method = method;
  motion.boundary = boundary;
  return motion;
}

Positions ghostAt(Sequence& sequence, double t) {
  std::vector<float> xyz;
  REQUIRE(sequence.evaluateGhost(t, xyz).ok());
  return toPositions(xyz);
}

void checkKeys(const Keyframes& k, const EncodingOptions& encoding, const std::vector<Method>& methods) {
  Sequence sequence = make(k, encoding);
  for (const Method method : methods)
    for (const BoundaryKind boundary : {BoundaryKind::Natural, BoundaryKind::Hermite, BoundaryKind::Periodic}) {
      CAPTURE(int(method));
      CAPTURE(int(boundary));
      REQUIRE(sequence.update(motionBy(method, boundary), evenTimes(k.keyCount())).ok());
      for (const Key& key : k.keys) {
        Frame frame;
        REQUIRE(sequence.evaluate(key.time, frame).ok());
        CHECK(largestDistance(toPositions(frame.positions), key.positions) < 1e-5 * diagonalOf(k));
        if (encoding.precision == Precision::Single) continue;
        CHECK(largestDistance(shapeAt(sequence, key.time), key.positions) < 1e-9 * diagonalOf(k));
      }
    }
}

}  // namespace

TEST_CASE("keys are reproduced by every method, with components, a ghost mesh and end tangents") {
  Shape parts = joined(box(1, 1, 10, 2, 2, 20), sphere({0, 0, 10.8}, 0.6, 6, 12));
  parts.positions.emplace_back(0.2, 0.1, 5);  // an unused vertex
  const Keyframes several = keyframes(parts, {bend(0), bend(1.2), bend(-1), twist(2)});
  const std::vector<Method> ofFaces = {Method::Lri, Method::RotationStrain, Method::Rimd};
  for (const Precision precision : {Precision::Single, Precision::Double, Precision::Exact})
    for (const Stretch stretch : {Stretch::Linear, Stretch::Log}) {
      CAPTURE(int(precision));
      CAPTURE(int(stretch));
      EncodingOptions encoding;
      encoding.precision = precision;
      encoding.stretch = stretch;
      encoding.reference = 1;
      checkKeys(
          bentBar({0, 70, -50, 120}), encoding,
          {Method::Lri, Method::Geodesic, Method::Linear, Method::CubicVertex, Method::RotationStrain, Method::Rimd});
      EncodingOptions ghost = encoding;
      ghost.ghostFaces = 800;
      ghost.optimalPlacement = stretch == Stretch::Log;
      checkKeys(bentBar({0, 70, -50, 120}, fineBar()), ghost, {Method::Lri});
      encoding.startTangent = mapped(parts.positions, bend(0.5));
      encoding.endTangent = mapped(parts.positions, twist(1.5));
      for (const int ghostFaces : {0, 100}) {
        CAPTURE(ghostFaces);
        encoding.ghostFaces = ghostFaces;
        checkKeys(several, encoding, ofFaces);
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
  const Map move = turn(Vec3(1, 2, -0.5), 2.2, Vec3(3, -7, 11));
  for (const Space& space : spaces())
    for (const Method method : {Method::Lri, Method::RotationStrain, Method::Rimd})
      for (const BoundaryKind boundary : {BoundaryKind::Natural, BoundaryKind::Periodic}) {
        if (method != Method::Lri && space.hasGhost()) continue;
        CAPTURE(space.name);
        CAPTURE(int(method));
        const Keyframes k = bentBar({0, 80, 20}, space.bar);
        Keyframes moved = k;
        for (Key& key : moved.keys) key.positions = mapped(key.positions, move);
        const MotionOptions motion = motionBy(method, boundary);
        Sequence a = make(k, space.encoding, motion), b = make(moved, space.encoding, motion);
        for (double t : slider) {
          CHECK(largestDistance(mapped(shapeAt(a, t), move), shapeAt(b, t)) < 1e-8 * diagonalOf(k));
          if (!space.hasGhost()) continue;
          CHECK(largestDistance(mapped(ghostAt(a, t), move), ghostAt(b, t)) < 1e-5 * diagonalOf(k));
        }
      }
}

TEST_CASE("moving one key rigidly changes only the global motion") {
  for (const Space& space : spaces()) {
    CAPTURE(space.name);
    Keyframes k = bentBar({0, 80, 20}, space.bar);
    Sequence a = make(k, space.encoding);
    k.keys[1].positions = mapped(k.keys[1].positions, turn(Vec3(0, 1, 1), 1.1, Vec3(5, 0, 0)));
    Sequence b = make(k, space.encoding);
    for (double t : slider) {
      const Positions x = shapeAt(a, t), y = shapeAt(b, t);
      CHECK(largestDistance(aligned(x, y), y) < 1e-8 * diagonalOf(k));
    }
  }
}

TEST_CASE("two keys with natural boundary give the geodesic") {
  for (const Space& space : spaces()) {
    CAPTURE(space.name);
    const Keyframes k = bentBar({10, 130}, space.bar);
    Sequence a = make(k, space.encoding), b = make(k, space.encoding, motionBy(Method::Geodesic));
    for (double t : slider) CHECK(largestDistance(shapeAt(a, t), shapeAt(b, t)) < 1e-10 * diagonalOf(k));
  }
}

TEST_CASE("rigid turns stay rigid, also of several parts") {
  const Vec3 axis(0.3, 1, 0.2);
  for (const Space& space : spaces())
    for (const bool several : {false, true}) {
      CAPTURE(space.name);
      CAPTURE(several);
      const Shape two = joined(space.bar, sphere({1.2, 0, 5}, 0.4));
      const Shape shape = several ? joined(two, sphere({0, 1.5, 9}, 0.3)) : space.bar;
      const Keyframes k = keyframes(
          shape, {turn(axis, 0), turn(axis, radians(100), Vec3(1, 0, 0)), turn(axis, radians(200), Vec3(0, 3, 0))});
      Sequence s = make(k, space.encoding);
      CHECK(s.stats().components == (several ? 3 : 1));
      for (double t : slider) CHECK(fitRigid(shape.positions, shapeAt(s, t)).largestDistance < 1e-9 * diagonalOf(k));
      // The sections turn evenly about the axis: 50 degrees after a quarter.
      const Positions quarter = shapeAt(s, 0.25);
      const Positions turned = mapped(shape.positions, turn(axis, radians(50)));
      CHECK(largestDistance(aligned(turned, quarter), quarter) < 1e-9 * 10);
      const Mat3 r = fitRigid(shape.positions, quarter).rotation;
      CHECK(logRotation(r).norm() == doctest::Approx(radians(50)).epsilon(1e-6));
    }
}

TEST_CASE("a twisted bar follows the analytic twist within KG 1.5") {
  for (const Space& space : spaces(2000)) {
    if (space.encoding.transfer == Transfer::Paper) continue;
    Sequence s = make(twistedBar({0, 180, 350}, space.bar), space.encoding);
    std::vector<Positions> exact, ours;
    for (int i = 0; i <= 40; ++i) {
      const double t = i / 40.0;
      // The twist angle is the natural spline through 0, 180, 350 degrees: m'' = 0 at the ends.
      const double a = 0, b = 180, c = 350;
      const double second = 3 * (c - 2 * b + a) / (2 * 0.25);  // m''(0.5) with h = 0.5
      const double u = t < 0.5 ? t / 0.5 : (1 - t) / 0.5, end = t < 0.5 ? a : c;
      const double angle = end + (b - end) * u + second * 0.25 / 6 * (u * u * u - u);
      exact.push_back(mapped(space.bar.positions, twist(radians(angle))));
      ours.push_back(aligned(shapeAt(s, t), exact.back()));
    }
    const double error = kgError(exact, ours, KgCentre::SequenceAverage);
    MESSAGE(space.name << ": KG " << error);
    CHECK(error < 1.5);
  }
}

TEST_CASE("a bend keeps its volume, unlike a linear blend") {
  for (const Space& space : spaces())
    for (const auto& [degrees, share] : {std::pair{120.0, 0.99}, std::pair{340.0, 0.96}}) {
      const Keyframes k = bentBar({0, degrees}, space.bar);
      Sequence s = make(k, space.encoding), l = make(k, space.encoding, motionBy(Method::Linear));
      const double keys =
          (enclosedVolume(k.keys[0].positions, k.faces) + enclosedVolume(k.keys[1].positions, k.faces)) / 2;
      const double ours = enclosedVolume(shapeAt(s, 0.5), k.faces) / keys,
                   blend = enclosedVolume(shapeAt(l, 0.5), k.faces) / keys;
      MESSAGE("bend by " << degrees << " degrees with " << space.name << ", halfway volume: LRI " << 100 * ours
                         << " %, linear blend " << 100 * blend << " %");
      CHECK(ours >= share);
      CHECK(blend < ours);
    }
}

namespace {

void checkHalfway(const std::function<Keyframes(const Shape&)>& keys) {
  for (const Space& space : spaces(2000)) {
    if (space.encoding.transfer == Transfer::Paper) continue;
    CAPTURE(space.name);
    const Keyframes k = keys(space.bar);
    Sequence s = make(k, space.encoding);
    const Positions& rest = k.keys[0].positions;
    const auto half = sectionTurns(rest, shapeAt(s, 0.5), space.sectionsPerUnit),
               whole = sectionTurns(rest, k.keys[1].positions, space.sectionsPerUnit);
    REQUIRE(half.size() == whole.size());
    for (std::size_t i = 0; i < half.size(); ++i)
      CHECK(half[i].norm() == doctest::Approx(whole[i].norm() / 2).epsilon(0.02));
  }
}

}  // namespace

TEST_CASE("a twist by 720 degrees is halfway a twist by 360") {
  checkHalfway([](const Shape& shape) { return twistedBar({0, 720}, shape); });
}

TEST_CASE("a bend by 540 degrees is halfway a bend by 270") {
  checkHalfway([](const Shape& shape) { return bentBar({0, 540}, shape); });
}

TEST_CASE("a sphere beside a bending bar keeps its distance, with a ghost of its own or without") {
  const double radius = 0.25, gap = 0.1;
  const Vec3 foot(0.5, 0, 5), centre(0.5 + gap + radius, 0, 5);
  // The ball moves rigidly with the bar's surface at z = 5.
  const auto map = [&](double degrees) -> Map {
    const Map bending = bend(radians(degrees)), ballTurn = turn(Vec3::UnitY(), radians(degrees) / 2);
    return [=](const Vec3& p) -> Vec3 {
      if ((p - centre).norm() <= radius * 1.001) return bending(foot) + ballTurn(Vec3(p - foot));
      return bending(p);
    };
  };
  for (const int ghostFaces : {0, 1000, 7}) {
    CAPTURE(ghostFaces);
    const Shape body = ghostFaces > 0 ? fineBar() : bar();
    const auto bodyVertices = static_cast<std::ptrdiff_t>(body.positions.size());
    const Keyframes k = keyframes(joined(body, sphere(centre, radius)), {map(0), map(60), map(120)});
    Sequence s = make(k, ghostly(ghostFaces));
    CHECK(s.stats().joinedComponents == (ghostFaces == 7 ? 1 : 0));
    CHECK(s.stats().components == 2);
    for (const Key& key : k.keys) CHECK(largestDistance(shapeAt(s, key.time), key.positions) < 1e-9 * diagonalOf(k));
    const auto distance = [&](const Positions& p) {
      double least = 1e9;
      for (auto v = p.begin() + bodyVertices; v != p.end(); ++v)
        for (auto u = p.begin(); u != p.begin() + bodyVertices; ++u) least = std::min(least, (*v - *u).norm());
      return least;
    };
    const Positions& keyed = k.keys[0].positions;
    const double rest = distance(keyed);
    for (double t : slider) {
      const Positions p = shapeAt(s, t);
      if (ghostFaces != 7) CHECK(std::abs(distance(p) - rest) < 0.02 * 2 * radius);
      CHECK(fitRigid({keyed.begin() + bodyVertices, keyed.end()}, {p.begin() + bodyVertices, p.end()}).largestDistance <
            0.01 * radius);
    }
  }
}

TEST_CASE("evaluate is a pure function of its arguments, and counts its work") {
  for (const Space& space : spaces()) {
    CAPTURE(space.name);
    const Keyframes k = bentBar({0, 70, -50, 120}, space.bar);
    EncodingOptions single = space.encoding;
    single.precision = Precision::Single;
    Sequence s = make(k, single);
    const SequenceStats before = s.stats();
    Frame first, again, other;
    REQUIRE(s.evaluate(0.37, first).ok());
    for (double t : slider) REQUIRE(s.evaluate(t, other).ok());
    REQUIRE(s.update(motionBy(Method::Lri, BoundaryKind::Periodic), {0, 0.1, 0.5, 1}).ok());
    REQUIRE(s.evaluate(0.8, other).ok());
    if (space.hasGhost()) ghostAt(s, 0.8);
    REQUIRE(s.update({}, evenTimes(4)).ok());
    REQUIRE(s.evaluate(0.37, again).ok());
    CHECK(first.positions == again.positions);
    CHECK(first.normals == again.normals);
    // Recomputing would have taken a different time.
    CHECK(s.stats().encodeMs == before.encodeMs);
    CHECK(s.stats().factorMs == before.factorMs);
    CHECK(s.stats().solves == before.solves + 3 + static_cast<long long>(slider.size()));
    Sequence twin = make(k, single);
    REQUIRE(twin.evaluate(0.37, again).ok());
    CHECK(first.positions == again.positions);
  }
}

TEST_CASE("nothing is encoded or factored again while scrubbing, toggling and moving key times") {
  Sequence s = make(bentBar({0, 70, -50, 120}), {});
  const SequenceStats before = s.stats();
  Frame frame;
  for (const BoundaryKind boundary : {BoundaryKind::Natural, BoundaryKind::Hermite, BoundaryKind::Periodic}) {
    REQUIRE(s.update(motionBy(Method::Lri, boundary), {0, 0.2, 0.7, 1.5}).ok());
    for (double t : slider) REQUIRE(s.evaluate(t, frame).ok());
  }
  // Recomputing would have taken a different time.
  CHECK(s.stats().encodeMs == before.encodeMs);
  CHECK(s.stats().factorMs == before.factorMs);
  CHECK(s.stats().solves == before.solves + 3 * static_cast<long long>(slider.size()));
}

}  // namespace shapespline::test::invariants_test
