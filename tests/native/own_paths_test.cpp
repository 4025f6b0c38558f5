// Own paths of faces are exact at the keys and fade where they disagree with LRI space. Tested with and without a base
// frame.
#include <doctest/doctest.h>

#include "core/mesh/measures.h"
#include "dense.h"
#include "pins.h"
#include "real_data.h"
#include "sequences.h"
#include "shapes.h"
#include "sweep.h"

namespace shapespline::test::own_paths_test {

namespace {

MotionOptions ownPaths(OwnPaths base, BoundaryKind boundary = BoundaryKind::Natural) {
  MotionOptions motion;
  motion.ownPaths = base;
  motion.boundary = boundary;
  return motion;
}

constexpr OwnPaths bases[] = {OwnPaths::Absolute, OwnPaths::Root};

double volumeError(Sequence& sequence, double t) {
  const double whole = enclosedVolume(shapeAt(sequence, 0), sequence.faces());
  return 100 * std::abs(enclosedVolume(shapeAt(sequence, t), sequence.faces()) / whole - 1);
}

Map then(const Map& first, const Map& second) {
  return [=](const Vec3& p) { return second(first(p)); };
}

}  // namespace

TEST_CASE("own paths: keys are exact, with components, a ghost, holding, and end tangents") {
  Shape shape = joined(box(1, 1, 10, 2, 2, 20), sphere({0, 0, 10.8}, 0.6, 6, 12));
  shape.positions.emplace_back(0.2, 0.1, 5);  // an unused vertex
  const Keyframes k = keyframes(shape, {bend(0), bend(1.2), bend(-1), twist(2)});
  EncodingOptions encoding;
  encoding.precision = Precision::Exact;
  encoding.endTangent = mapped(shape.positions, twist(1.5));
  for (const OwnPaths base : bases)
    for (const int ghostFaces : {0, 100})
      for (const BoundaryKind boundary : {BoundaryKind::Natural, BoundaryKind::Hermite, BoundaryKind::Periodic}) {
        CAPTURE(int(boundary));
        CAPTURE(ghostFaces);
        encoding.ghostFaces = ghostFaces;
        MotionOptions motion = ownPaths(base, boundary);
        Sequence sequence = sequenceOf(k, encoding, motion);
        const Positions free = shapeAt(sequence, 0.4);
        for (const Key& key : k.keys)
          CHECK(largestDistance(shapeAt(sequence, key.time), key.positions) < 1e-9 * diagonalOf(k));
        motion.hold = true;
        motion.pins = {{0, 0.1, -1}};
        REQUIRE(sequence.update(motion, evenTimes(4)).ok());
        CHECK(largestDistance(shapeAt(sequence, 0.4), free) > 1e-6);
        for (const Key& key : k.keys)
          CHECK(largestDistance(shapeAt(sequence, key.time), key.positions) < 1e-7 * diagonalOf(k));
      }
}

TEST_CASE("own paths: the volume is kept, also if a bar is twisted by a full turn") {
  for (const OwnPaths base : bases) {
    Sequence bent = sequenceOf(bentBar({0, 120}), doublePrecision(), ownPaths(base));
    for (const double t : {0.1, 0.3, 0.5, 0.8}) CHECK(volumeError(bent, t) < 0.2);
    Sequence twisted = sequenceOf(twistedBar({0, 360}), doublePrecision(), ownPaths(base));
    CHECK(volumeError(twisted, 0.5) < 4);
  }
}

TEST_CASE("own paths: relative to a frame, rotating a whole key changes nothing") {
  const std::vector<Map> maps = {bend(0), bend(1.5), twist(1)};
  const std::vector<Map> turned = {maps[0], maps[1], then(maps[2], turn({1, 2, -1}, 1.1, {3, -1, 2}))};
  const auto apart = [&](const MotionOptions& motion) {
    Sequence here = sequenceOf(keyframes(bar(), maps), doublePrecision(), motion);
    Sequence there = sequenceOf(keyframes(bar(), turned), doublePrecision(), motion);
    double largest = 0;
    for (const double t : {0.2, 0.7, 0.9}) {
      const Positions shape = shapeAt(here, t);
      largest = std::max(largest, largestDistance(aligned(shapeAt(there, t), shape), shape));
    }
    return largest / 10;
  };
  CHECK(apart(ownPaths(OwnPaths::Root)) < 1e-9);
  CHECK(apart(ownPaths(OwnPaths::Absolute)) > 1e-4);
}

TEST_CASE("own paths: a loop continues smoothly from its last key") {
  const Map step = turn({0, 1, 0}, 0.7, {2, 0, 1});
  const Keyframes k = keyframes(bar(), {bend(0), bend(0.8), bend(-0.5), step});
  for (const OwnPaths base : bases) {
    Sequence sequence = sequenceOf(k, doublePrecision(), ownPaths(base, BoundaryKind::Periodic));
    for (const double t : {0.0, 0.2, 0.45, 0.9}) {
      const Positions moved = mapped(shapeAt(sequence, t), step);
      CHECK(largestDistance(shapeAt(sequence, t + 1), moved) < 1e-9 * diagonalOf(k));
    }
    CHECK(sweep(sequence).growth < 2);
  }
}

TEST_CASE("own paths: unsupported options are refused") {
  Sequence sequence = sequenceOf(bentBar({0, 60, 90}), doublePrecision());
  MotionOptions motion = ownPaths(OwnPaths::Root);
  motion.turns = {{1, 1}};
  CHECK(sequence.update(motion, evenTimes(3)).error().message.find("Full turns") != std::string::npos);
  motion.turns.clear();
  for (const Method method : {Method::Geodesic, Method::CubicVertex, Method::Rimd}) {
    motion.method = method;
    CHECK(sequence.update(motion, evenTimes(3)).error().message.find("'lri'") != std::string::npos);
  }
  EncodingOptions paper;
  paper.ghostFaces = 300, paper.transfer = Transfer::Paper;
  CHECK(!Sequence::create(bentBar({0, 60}), paper, ownPaths(OwnPaths::Root)).ok());
}

TEST_CASE("own paths: the motion has no jumps" * dense) {
  if (!hasData(lionPoses)) return;
  std::vector<std::string> first(lionPoses.begin(), lionPoses.begin() + 4);
  for (const OwnPaths base : bases) {
    Sequence sequence = sequenceOf(realKeyframes(first), doublePrecision(), ownPaths(base));
    const Sweep found = sweep(sequence, {.samples = 10, .fold = 12, .zooms = 3});
    MESSAGE("largest step " << found.step << " % of the diagonal, zoomed " << found.zoomedStep << ", growth "
                            << found.growth);
    CHECK(found.zoomedStep < found.step / (8.0 * 8 * 8));
  }
}

}  // namespace shapespline::test::own_paths_test
