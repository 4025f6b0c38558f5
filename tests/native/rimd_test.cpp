// Rotation-invariant mesh differences of faces are exact at the keys, follow common rigid motions of all keys, and stay
// near LRI.
#include <doctest/doctest.h>

#include "core/mesh/measures.h"
#include "dense.h"
#include "real_data.h"
#include "sequences.h"
#include "shapes.h"
#include "sweep.h"

namespace shapespline::test::rimd_test {

namespace {

MotionOptions rimd(BoundaryKind boundary = BoundaryKind::Natural) {
  MotionOptions motion;
  motion.method = Method::Rimd;
  motion.boundary = boundary;
  return motion;
}

// In percent of the first volume, between two keys.
double volumeError(Sequence& sequence, double t) {
  const double whole = enclosedVolume(shapeAt(sequence, 0), sequence.faces());
  return 100 * std::abs(enclosedVolume(shapeAt(sequence, t), sequence.faces()) / whole - 1);
}

}  // namespace

TEST_CASE("rimd: keys are exact, with components, a ghost and end tangents") {
  Shape shape = joined(box(1, 1, 10, 2, 2, 20), sphere({0, 0, 10.8}, 0.6, 6, 12));
  shape.positions.emplace_back(0.2, 0.1, 5);  // an unused vertex
  const Keyframes k = keyframes(shape, {bend(0), bend(1.2), bend(-1), twist(2)});
  EncodingOptions encoding;
  encoding.precision = Precision::Exact;
  encoding.startTangent = mapped(shape.positions, bend(0.5));
  for (const int ghostFaces : {0, 100})
    for (const Stretch stretch : {Stretch::Linear, Stretch::Log})
      for (const BoundaryKind boundary : {BoundaryKind::Natural, BoundaryKind::Hermite, BoundaryKind::Periodic}) {
        CAPTURE(int(boundary));
        CAPTURE(ghostFaces);
        encoding.stretch = stretch;
        encoding.ghostFaces = ghostFaces;
        Sequence sequence = sequenceOf(k, encoding, rimd(boundary));
        for (const Key& key : k.keys)
          CHECK(largestDistance(shapeAt(sequence, key.time), key.positions) < 1e-9 * diagonalOf(k));
      }
}

TEST_CASE("rimd: the volume is kept, also if a bar is twisted by a full turn") {
  Sequence bent = sequenceOf(bentBar({0, 120}), doublePrecision(), rimd());
  for (const double t : {0.1, 0.3, 0.5, 0.8}) CHECK(volumeError(bent, t) < 0.2);
  Sequence twisted = sequenceOf(twistedBar({0, 360}), doublePrecision(), rimd());
  CHECK(volumeError(twisted, 0.5) < 4);
  Vec3 turned = Vec3::Zero();
  for (const Vec3& turn : sectionTurns(bar().positions, shapeAt(twisted, 0.5), 4)) turned += turn;
  CHECK(turned.norm() == doctest::Approx(pi).epsilon(0.02));
}

TEST_CASE("rimd: if all keys are moved rigidly, so is the shape") {
  const Map move = turn({1, 2, -1}, 2.1, {3, -1, 2});
  const std::vector<Map> maps = {bend(0), bend(1.5), twist(1)};
  std::vector<Map> moved;
  for (const Map& map : maps) moved.push_back([map, move](const Vec3& p) { return move(map(p)); });
  Sequence here = sequenceOf(keyframes(bar(), maps), doublePrecision(), rimd());
  Sequence there = sequenceOf(keyframes(bar(), moved), doublePrecision(), rimd());
  for (const double t : {-0.2, 0.2, 0.7, 1.3})
    CHECK(largestDistance(mapped(shapeAt(here, t), move), shapeAt(there, t)) < 1e-8);
}

TEST_CASE("rimd: close to LRI space and smooth, without holding") {
  const Keyframes k = keyframes(bar(), {bend(0), bend(1.5), twist(2)});
  Sequence sequence = sequenceOf(k, doublePrecision(), rimd());
  const Positions rival = shapeAt(sequence, 0.3);
  CHECK(sweep(sequence).growth < 2);
  MotionOptions held = rimd();
  held.hold = true;
  CHECK(!sequence.update(held, evenTimes(3)).ok());
  REQUIRE(sequence.update({}, evenTimes(3)).ok());
  const double apart = largestDistance(rival, shapeAt(sequence, 0.3)) / diagonalOf(k);
  CHECK(apart > 1e-6);
  CHECK(apart < 0.02);
}

TEST_CASE("rimd: the motion has no jumps" * dense) {
  if (!hasData(lionPoses)) return;
  std::vector<std::string> first(lionPoses.begin(), lionPoses.begin() + 4);
  Sequence sequence = sequenceOf(realKeyframes(first), doublePrecision(), rimd());
  const Sweep found = sweep(sequence, {.samples = 10, .fold = 12, .zooms = 3});
  MESSAGE("largest step " << found.step << " % of the diagonal, zoomed " << found.zoomedStep << ", growth "
                          << found.growth);
  CHECK(found.zoomedStep < found.step / (8.0 * 8 * 8));
}

}  // namespace shapespline::test::rimd_test
