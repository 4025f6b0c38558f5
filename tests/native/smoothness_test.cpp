// Motions have no jumps in time, at any setting, on synthetic and real shapes: dense sweeps with a zoom into the
// largest steps.
#include <doctest/doctest.h>

#include "dense.h"
#include "one_sided.h"
#include "pins.h"
#include "real_data.h"
#include "sweep.h"

namespace shapespline::test::smoothness_test {

namespace {

// Allowed step of a vertex at about 1e-10 of the range, in percent of the diagonal.
constexpr double minStep = 1e-4;
// A patch never rotates faster than this multiple of its median speed, times the unevenness that the end speeds cause
// in an even rotation.
constexpr double largestUnevenness = 4;
// Maximum growth of the acceleration when the spacing is halved five times. A corner has 32.
constexpr double largestGrowth = 4;

struct Boundary {
  std::string name;
  MotionOptions motion;
};

MotionOptions with(BoundaryKind kind, double speed = 1) {
  MotionOptions motion;
  motion.boundary = kind;
  motion.startSpeed = motion.endSpeed = speed;
  return motion;
}

const std::vector<Boundary>& boundaries() {
  static const std::vector<Boundary> all = {{"natural", with(BoundaryKind::Natural)},
                                            {"periodic", with(BoundaryKind::Periodic)},
                                            {"hermite, speeds 1", with(BoundaryKind::Hermite)},
                                            {"hermite, speeds 0", with(BoundaryKind::Hermite, 0)},
                                            {"hermite, speeds 4", with(BoundaryKind::Hermite, 4)}};
  return all;
}

// Largest over median speed of an evenly rotating box with the same number of keys and the same end speeds. 1 if both
// speeds are 1.
std::pair<double, double> unevennessAskedFor(const Sequence& sequence) {
  const MotionOptions& motion = sequence.motion().options();
  if (motion.boundary != BoundaryKind::Hermite || (motion.startSpeed == 1 && motion.endSpeed == 1)) return {1, 1};
  std::vector<Map> turns;
  std::vector<double> times;
  for (const double t : sequence.motion().keyTimes())
    times.push_back(t), turns.push_back(turn(Vec3::UnitX(), radians(10.0 * times.size())));
  Sequence even = sequenceOf(keyframes(box(1, 2, 3, 1, 1, 1), turns, times), doublePrecision(), motion);
  const Sweep s = sweep(even, {sweepDensity().samples, 2, 0});
  return {std::max(1.0, s.inside), std::max(1.0, s.margin)};
}

void checkSweep(const std::string& what, Sequence& sequence) {
  CAPTURE(what);
  const Sweep s = sweep(sequence);
  const auto [inside, margin] = unevennessAskedFor(sequence);
  if (sweepsArePrinted())
    MESSAGE("SWEEP | " << what << " | step " << s.step << " % at " << s.stepAt << " -> " << s.zoomedStep
                       << " % at dt = " << s.zoomedSpacing << " | patch " << s.turn << " degrees at " << s.turnAt
                       << " | speed inside " << s.inside << ", margins " << s.margin << " | acceleration grows "
                       << s.growth);
  CAPTURE(s.stepAt);
  CAPTURE(s.turnAt);
  CHECK(s.zoomedStep <= std::max(minStep, 3 * s.step * s.zoomedSpacing / s.spacing));
  CHECK(s.inside <= largestUnevenness * inside);
  CHECK(s.margin <= largestUnevenness * margin);
  CHECK(s.growth <= largestGrowth * inside);  // coarse samples exaggerate end speeds of 4; a corner has 32
}

// Checks the first `count` of the boundaries above.
void checkBoundaries(const std::string& what, const Keyframes& k, const EncodingOptions& encoding, std::size_t count) {
  Sequence sequence = sequenceOf(k, encoding);
  const std::vector<double> times = [&] {
    std::vector<double> list;
    for (const Key& key : k.keys) list.push_back(key.time);
    return list;
  }();
  for (std::size_t i = 0; i < std::min(count, boundaries().size()); ++i) {
    REQUIRE(sequence.update(boundaries()[i].motion, times).ok());
    checkSweep(what + ", " + boundaries()[i].name, sequence);
  }
}

// Holding corrects shapes but not patches. It must not cause jumps, alone or with pins. Checks the first `count` of the
// boundaries above.
void checkHeld(const std::string& name, const Keyframes& k, std::size_t count) {
  Sequence sequence = sequenceOf(k, doublePrecision());
  std::vector<double> times;
  for (const Key& key : k.keys) times.push_back(key.time);
  const std::vector<Pin> pins = everyPin(k);
  struct Held {
    std::string words;
    bool hold;
    std::vector<Pin> pins;
  };
  for (std::size_t i = 0; i < std::min(count, boundaries().size()); ++i)
    for (const Held& held : {Held{"held", true, {}}, Held{"pins", false, pins}, Held{"held and pins", true, pins}}) {
      MotionOptions motion = boundaries()[i].motion;
      motion.hold = held.hold;
      motion.pins = held.pins;
      REQUIRE(sequence.update(motion, times).ok());
      checkSweep(name + ", " + boundaries()[i].name + ", " + held.words, sequence);
    }
}

EncodingOptions withGhost(int faces, Transfer transfer = Transfer::Exact) {
  EncodingOptions options = doublePrecision();
  options.ghostFaces = faces;
  options.transfer = transfer;
  return options;
}

EncodingOptions withLogStretch() {
  EncodingOptions options = doublePrecision();
  options.stretch = Stretch::Log;
  return options;
}

// Checks all options on small shapes and in manual runs. For other shapes, the cost determines which sweeps always run.
void checkKeyframes(const std::string& name, const Keyframes& k) {
  const bool full = sweepsAreFull(), small = k.faceCount() < 1500, large = k.faceCount() > 6000;
  checkBoundaries(name, k, doublePrecision(), full || small ? 5 : large ? 1 : 2);
  for (const int ghost : {400, 1000}) {
    if (k.faceCount() < 2 * ghost || (!full && (large || ghost == 1000))) continue;
    checkBoundaries(name + ", " + std::to_string(ghost) + " ghost faces", k, withGhost(ghost), full ? 5 : 1);
  }
  if (k.keyCount() > 2) checkHeld(name, k, full ? 5 : small ? 2 : 1);
  if (full || small) checkBoundaries(name + ", log stretch", k, withLogStretch(), full ? 5 : 1);
}

void checkRealSet(const std::vector<std::string>& files, const ImportOptions& import = {}) {
  if (hasData(files)) checkKeyframes(files.front(), realKeyframes(files, import));
}

// For files that a person recognises as poses of one mesh, but the importer may not.
void checkRealSetIfRead(const std::vector<std::string>& files) {
  if (!hasData(files)) return;
  const auto import = realFiles(files).import();
  if (import.ok()) return checkKeyframes(files.front(), import->keyframes);
  MESSAGE("SKIPPED: " << import.error().message);
}

ImportOptions sampled(const std::string& animation, int keys = 8) {
  ImportOptions options;
  options.animation = animation;
  options.sampleCount = keys;
  options.sampleAsked = true;
  return options;
}

}  // namespace

TEST_CASE("sweep: a cubic blend of vertices passes, and a corner is seen") {
  Sequence sequence = sequenceOf(bentBar({0, 40, -20, 60}), doublePrecision());
  MotionOptions motion;
  motion.method = Method::CubicVertex;
  REQUIRE(sequence.update(motion, evenTimes(4)).ok());
  checkSweep("a cubic blend of vertices", sequence);
  motion.method = Method::Linear;
  REQUIRE(sequence.update(motion, evenTimes(4)).ok());
  CHECK(sweep(sequence).growth > 16);
}

TEST_CASE("sweep: bars with large rotations") {
  checkBoundaries("twist 0/180/350", twistedBar({0, 180, 350}), doublePrecision(), 5);
  checkBoundaries("twist 0/720", twistedBar({0, 720}), doublePrecision(), 5);
  checkBoundaries("bend 0/540", bentBar({0, 540}), doublePrecision(), 5);
  checkBoundaries("bend 0/120/-60/200", bentBar({0, 120, -60, 200}), doublePrecision(), 5);
  checkBoundaries("bend 0/120/-60/200, 400 ghost faces", bentBar({0, 120, -60, 200}), withGhost(400), 5);
  checkBoundaries("bend 0/120/-60/200, 400 ghost faces as published", bentBar({0, 120, -60, 200}),
                  withGhost(400, Transfer::Paper), 2);
}

TEST_CASE("smooth: second differences of bars are small throughout") {
  const double dt = 1e-3;
  const int places = sweepsAreFull() ? 1800 : 180;
  for (const Keyframes& k : {twistedBar({0, 180, 350}), twistedBar({0, 720}), bentBar({0, 540})}) {
    Sequence sequence = sequenceOf(k, doublePrecision());
    double largest = 0, where = 0;
    for (int i = 0; i <= places; ++i) {
      const double t = -0.4 + 1.8 * i / places;
      const double d = secondDifference(shapeAt(sequence, t - dt), shapeAt(sequence, t), shapeAt(sequence, t + dt));
      if (d > largest) largest = d, where = t;
    }
    largest /= boundingDiagonal(std::vector<const Positions*>{&k.keys[0].positions});
    MESSAGE("largest second difference " << largest << " of the diagonal, at " << where);
    CHECK(largest <= 1e-4);
  }
}

TEST_CASE("smooth: accelerations do not jump at inner keys") {
  for (const Keyframes& k : {twistedBar({0, 180, 350}), bentBar({0, 70, -50, 120}), bentBar({0, 120, -60, 200})}) {
    Sequence sequence = sequenceOf(k, doublePrecision());
    const PatchTurning patches(sequence);
    for (int j = 1; j + 1 < k.keyCount(); ++j) {
      const Jumps jumps = jumpsAt(sequence, patches, k.keys[j].time);
      CHECK(jumps.angularAcceleration <= 1e-3);
      CHECK(jumps.acceleration <= 1e-3);
    }
    MotionOptions corners;
    corners.method = Method::Geodesic;
    REQUIRE(sequence.update(corners, evenTimes(k.keyCount())).ok());
    CHECK(jumpsAt(sequence, patches, k.keys[1].time).velocity > 0.01);
  }
}

TEST_CASE("smooth: with quick Hermite ends, steps halve with time at the end of the slider") {
  Sequence sequence = sequenceOf(twistedBar({0, 150}), doublePrecision(), with(BoundaryKind::Hermite, 4));
  const int parts = 64;
  std::vector<Positions> shapes;
  for (int i = 0; i <= parts; ++i) shapes.push_back(shapeAt(sequence, 1.3 + 0.04 * i / parts));
  const auto largestStep = [&](int every) {
    double largest = 0;
    for (int i = every; i <= parts; i += every)
      largest = std::max(largest, largestDistance(shapes[i - every], shapes[i]));
    return largest;
  };
  for (int every = 8; every > 1; every /= 2) CHECK(largestStep(every / 2) <= 0.6 * largestStep(every));
}

TEST_CASE("sweep: cactus") { checkRealSet({"cactus/cactus-1.glb", "cactus/cactus-2.glb", "cactus/cactus-3.glb"}); }
TEST_CASE("sweep: horse, morph targets" * dense) { checkRealSet({"morph/Horse.glb"}); }
TEST_CASE("sweep: sphere, morph targets" * dense) {
  checkRealSet({"morph/AnimatedMorphSphere.gltf", "morph/AnimatedMorphSphere.bin"});
}
TEST_CASE("sweep: stress test, morph targets") { checkRealSet({"morph/MorphStressTest.gltf"}); }
TEST_CASE("sweep: man, skin") {
  ImportOptions options;
  options.sampleCount = 8;
  options.sampleAsked = true;
  checkRealSet({"skin/CesiumMan.glb"}, options);
}
TEST_CASE("sweep: fox, skin, Survey" * dense) { checkRealSet({"skin/Fox.glb"}, sampled("Survey")); }
TEST_CASE("sweep: fox, skin, Walk" * dense) { checkRealSet({"skin/Fox.glb"}, sampled("Walk")); }
TEST_CASE("sweep: fox, skin, Run") { checkRealSet({"skin/Fox.glb"}, sampled("Run")); }
TEST_CASE("sweep: soldier, skin, Run" * dense) { checkRealSet({"skin/Soldier.glb"}, sampled("Run", 5)); }
TEST_CASE("sweep: soldier, skin, Walk" * dense) { checkRealSet({"skin/Soldier.glb"}, sampled("Walk", 5)); }
TEST_CASE("sweep: soldier, skin, Idle") { checkRealSet({"skin/Soldier.glb"}, sampled("Idle", 5)); }
TEST_CASE("sweep: wolf") { checkRealSet(wolfPoses); }
TEST_CASE("sweep: low-poly cat") {
  checkRealSet({"obj/lowpoly-cat/cat_000001.obj", "obj/lowpoly-cat/cat_000007.obj", "obj/lowpoly-cat/cat_000013.obj",
                "obj/lowpoly-cat/cat_000019.obj", "obj/lowpoly-cat/cat_000025.obj", "obj/lowpoly-cat/cat_000031.obj"});
}
TEST_CASE("sweep: low-poly cat and its reference, which is ten times as large") {
  const std::vector<std::string> files = {"obj/lowpoly-cat/cat_000001.obj",   "obj/lowpoly-cat/cat_000007.obj",
                                          "obj/lowpoly-cat/cat_000013.obj",   "obj/lowpoly-cat/cat_000019.obj",
                                          "obj/lowpoly-cat/cat_000025.obj",   "obj/lowpoly-cat/cat_000031.obj",
                                          "obj/lowpoly-cat/cat_reference.obj"};
  if (!hasData(files)) return;
  const Keyframes k = realKeyframes(files);
  MotionOptions motion = with(BoundaryKind::Periodic);
  motion.hold = true;
  Sequence sequence = sequenceOf(k, doublePrecision(), motion);
  CHECK(sweep(sequence, {60, 4, 14}).growth <= largestGrowth);
}
TEST_CASE("sweep: saddle") { checkRealSet({"turns/saddle/monkey_saddle_1.ply", "turns/saddle/monkey_saddle_2.ply"}); }
TEST_CASE("sweep: plate") {
  checkRealSet({"turns/plate/plate121.ply", "turns/plate/plate121_rolledA.ply", "turns/plate/plate121_rolledB.ply"});
}
TEST_CASE("sweep: plate, rolled one way") {
  checkRealSet({"turns/plate/plate121.ply", "turns/plate/plate121_rolledA.ply"});
}
TEST_CASE("sweep: plate, rolled the other way") {
  checkRealSet({"turns/plate/plate121.ply", "turns/plate/plate121_rolledB.ply"});
}
TEST_CASE("sweep: cat with turns of 170 degrees" * dense) {
  checkRealSet({"turns/cat/cat2.off", "turns/cat/cat5.off", "turns/cat/cat8.off"});
}
TEST_CASE("sweep: lion with turns of 175 degrees") { checkRealSet(lionPoses); }
TEST_CASE("sweep: bent bar, vertices split by pose") {
  checkRealSetIfRead({"blender/baked_flat_0.glb", "blender/baked_flat_1.glb", "blender/baked_flat_2.glb"});
}
TEST_CASE("sweep: twisted head") { checkRealSetIfRead({"blender/suzsm_0.glb", "blender/suzsm_1.glb"}); }
TEST_CASE("sweep: twisted head, with quads cut along the other diagonal") {
  checkRealSetIfRead({"blender/suzsm_0.glb", "blender/suzsm_1.glb", "blender/suzsm_2.glb"});
}

}  // namespace shapespline::test::smoothness_test
