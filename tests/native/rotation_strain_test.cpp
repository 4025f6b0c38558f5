// Rotation-strain coordinates and rotation-invariant mesh differences by increments are near the truth, and report
// their failures.
#include <doctest/doctest.h>

#include "core/mesh/measures.h"
#include "dense.h"
#include "real_data.h"
#include "sequences.h"
#include "shapes.h"
#include "sweep.h"

namespace shapespline::test::rotation_strain_test {

namespace {

MotionOptions rotationStrain(BoundaryKind boundary = BoundaryKind::Natural) {
  MotionOptions motion;
  motion.method = Method::RotationStrain;
  motion.boundary = boundary;
  return motion;
}

MotionOptions rimd() {
  MotionOptions motion;
  motion.method = Method::Rimd;
  return motion;
}

// In percent of the first volume, between two keys.
double volumeError(Sequence& sequence, double t) {
  const double whole = enclosedVolume(shapeAt(sequence, 0), sequence.faces());
  return 100 * std::abs(enclosedVolume(shapeAt(sequence, t), sequence.faces()) / whole - 1);
}

bool isTorn(const Sequence& sequence) {
  return std::any_of(sequence.warnings().begin(), sequence.warnings().end(),
                     [](const Warning& w) { return w.code == "torn-faces" && w.key == 1 && w.face >= 0; });
}

double largestVolumeError(Sequence& sequence) {
  double largest = 0;
  for (const double t : {0.1, 0.3, 0.5, 0.8}) largest = std::max(largest, volumeError(sequence, t));
  return largest;
}

}  // namespace

TEST_CASE("rotation-strain: end tangents give the direction at the ends") {
  const Keyframes k = bentBar({0, 60});
  EncodingOptions encoding = doublePrecision();
  encoding.startTangent = mapped(bar().positions, twist(0.4));
  Sequence sequence = sequenceOf(k, encoding, rotationStrain(BoundaryKind::Hermite));
  const double h = 1e-4;
  const Positions from = shapeAt(sequence, 0), to = shapeAt(sequence, h);
  // The initial twist rate is 0.4 per second.
  Vec3 turned = Vec3::Zero();
  for (const Vec3& turn : sectionTurns(from, to, 4)) turned += turn / h;
  CHECK(turned.z() == doctest::Approx(0.4).epsilon(0.01));
}

TEST_CASE("rotation-strain: a bent bar keeps its volume, a vertex blend loses it") {
  Sequence sequence = sequenceOf(bentBar({0, 120}), doublePrecision(), rotationStrain());
  CHECK(largestVolumeError(sequence) < 0.2);
  CHECK(sequence.warnings().empty());
  MotionOptions linear;
  linear.method = Method::Linear;
  REQUIRE(sequence.update(linear, evenTimes(2)).ok());
  CHECK(largestVolumeError(sequence) > 10);
}

TEST_CASE("rotation-strain: turns add up along the surface, and a tear near a full turn gives a warning") {
  for (const double degrees : {300.0, 640.0}) {
    Sequence far = sequenceOf(twistedBar({0, degrees}), doublePrecision(), rotationStrain());
    Vec3 turned = Vec3::Zero();
    for (const Vec3& turn : sectionTurns(bar().positions, shapeAt(far, 0.5), 4)) turned += turn;
    CHECK(turned.norm() == doctest::Approx(radians(degrees / 2)).epsilon(0.05));
    CHECK(isTorn(far) == (degrees > 360));
  }
  Sequence whole = sequenceOf(twistedBar({0, 360}), doublePrecision(), rotationStrain());
  CHECK(isTorn(whole));
  MotionOptions lri;
  REQUIRE(whole.update(lri, evenTimes(2)).ok());
  CHECK(!isTorn(whole));
}

TEST_CASE("rotation-strain: unsupported options are refused") {
  Sequence sequence = sequenceOf(bentBar({0, 60, 90}), doublePrecision());
  const auto refused = [&](const MotionOptions& motion, const std::string& words) {
    const Status status = sequence.update(motion, evenTimes(3));
    REQUIRE(!status.ok());
    CHECK(status.error().code == ErrorCode::InvalidOption);
    CHECK(status.error().message.find(words) != std::string::npos);
  };
  MotionOptions held = rotationStrain(), pinned = rotationStrain(), turned = rotationStrain();
  held.hold = true;
  refused(held, "holding");
  pinned.pins = {{0, 0.1, -1}};
  refused(pinned, "pins");
  turned.turns = {{1, 1}};
  refused(turned, "full turns");
  turned.turns = {{1, 0}};
  CHECK(sequence.update(turned, evenTimes(3)).ok());

  EncodingOptions paper;
  paper.ghostFaces = 300, paper.transfer = Transfer::Paper;
  const auto ghost = Sequence::create(bentBar({0, 60}), paper, rotationStrain());
  REQUIRE(!ghost.ok());
  CHECK(ghost.error().message.find("exact transfer") != std::string::npos);
}

TEST_CASE("rotation-strain: its shapes leave the plane of LRI space, and bend in their own") {
  Sequence sequence = sequenceOf(keyframes(bar(), {bend(0), bend(2), twist(2)}), doublePrecision(), rotationStrain());
  const auto curve = sequence.featureCurve();
  const ShapePlane plane = curve->plane({0, 0.25, 0.5, 1});
  for (const int key : {0, 2, 3}) CHECK(plane.distance[key] < 1e-6);
  CHECK(plane.distance[1] > 1e-4);
  CHECK(plane.distance[1] < 0.2);
  const std::vector<double> own = curve->bendingEnergy({0.4, 0.5, 0.6});
  CHECK(own[1] > 1);
  CHECK(own[1] < 2 * std::max(own[0], own[2]));
}

TEST_CASE("rimd: the volume is kept, also if a bar is twisted by a full turn") {
  Sequence bent = sequenceOf(bentBar({0, 120}), doublePrecision(), rimd());
  CHECK(largestVolumeError(bent) < 0.2);
  Sequence twisted = sequenceOf(twistedBar({0, 360}), doublePrecision(), rimd());
  CHECK(volumeError(twisted, 0.5) < 4);
  Vec3 turned = Vec3::Zero();
  for (const Vec3& turn : sectionTurns(bar().positions, shapeAt(twisted, 0.5), 4)) turned += turn;
  CHECK(turned.norm() == doctest::Approx(pi).epsilon(0.02));
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

TEST_CASE("rotation-strain and rimd: the motion has no jumps" * dense) {
  if (!hasData(lionPoses)) return;
  std::vector<std::string> first(lionPoses.begin(), lionPoses.begin() + 4);
  for (const MotionOptions& motion : {rotationStrain(), rimd()}) {
    Sequence sequence = sequenceOf(realKeyframes(first), doublePrecision(), motion);
    const Sweep found = sweep(sequence, {.samples = 20, .fold = 12, .zooms = 3});
    MESSAGE("largest step " << found.step << " % of the diagonal, zoomed " << found.zoomedStep << ", growth "
                            << found.growth);
    CHECK(found.zoomedStep < found.step / (8.0 * 8 * 8));
  }
}

}  // namespace shapespline::test::rotation_strain_test
