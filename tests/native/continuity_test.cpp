// The motion is continuous in its keys: nearly equal descriptions of a shape give nearly equal motions.
#include <doctest/doctest.h>

#include <algorithm>

#include "dense.h"
#include "pins.h"
#include "real_data.h"
#include "sequences.h"
#include "shapes.h"
#include "shapes/random.h"

namespace shapespline::test::continuity_test {

namespace {

// Bends in one plane, twists, and rotations of the whole about a third axis.
Keyframes poses() {
  const auto pose = [](double bent, double twisted, double turned) -> Map {
    return [=](const Vec3& p) -> Vec3 {
      return turn(Vec3(1, 2, 0.5), radians(turned))(bend(radians(bent))(twist(radians(twisted))(p)));
    };
  };
  return keyframes(box(1, 1.3, 10, 2, 3, 20), {pose(0, 0, 0), pose(110, 60, 80), pose(-40, 130, -20), pose(70, 20, 60)},
                   {0, 1, 2.2, 3});
}

// A limb of five segments. Each joint rotates by up to `most` degrees from rest, the whole by up to `whole`. Linear
// skinning collapses joints with large rotations, which makes their direction ambiguous.
Keyframes limb(unsigned seed, int keys, double most, double whole) {
  Random random(seed);
  const auto vector = [&] { return Vec3{random.uniform(-1, 1), random.uniform(-1, 1), random.uniform(-1, 1)}; };
  constexpr int joints = 4;
  constexpr double spacing = 2, width = 0.8;
  Shape rest = box(1, 1.2, spacing * (joints + 1), 4, 5, 9 * (joints + 1));
  for (Vec3& p : rest.positions) p += 0.025 * vector();
  std::vector<Map> maps;
  for (int j = 0; j < keys; ++j) {
    std::vector<Mat3> turns;
    const auto turnUpTo = [&](double degrees) {
      const Vec3 axis = vector().normalized();
      return expRotation(axis * radians(degrees) * random.uniform(0, 1));
    };
    for (int i = 0; i < joints; ++i) turns.push_back(turnUpTo(most));
    const Mat3 all = turnUpTo(whole);
    maps.push_back([=](const Vec3& from) -> Vec3 {
      Vec3 p = from;
      for (int i = joints - 1; i >= 0; --i) {
        const Vec3 centre(0, 0, spacing * (i + 1));
        const double w = std::clamp((from.z() - centre.z()) / width + 0.5, 0.0, 1.0), share = w * w * (3 - 2 * w);
        const Vec3 q = p - centre;
        p = centre + (1 - share) * q + share * (turns[i] * q);
      }
      return all * p;
    });
  }
  return keyframes(rest, maps);
}

Keyframes reversed(Keyframes k) {
  const double sum = k.keys.front().time + k.keys.back().time;
  std::reverse(k.keys.begin(), k.keys.end());
  for (Key& key : k.keys) key.time = sum - key.time;
  return k;
}

// Moves every vertex by up to `size` of the diagonal along each axis.
Keyframes noisy(Keyframes k, double size, unsigned seed) {
  Random random(seed);
  const double most = size * diagonalOf(k);
  for (Key& key : k.keys)
    for (Vec3& p : key.positions)
      p += Vec3{random.uniform(-most, most), random.uniform(-most, most), random.uniform(-most, most)};
  return k;
}

// Distances in percent of the diagonal: the largest mean over the vertices at any time, and the worst single distance.
struct Difference {
  double mean = 0, worst = 0, beyond = 0;  // beyond: the worst up to 0.8 mean intervals beyond the keys
};

Difference difference(Sequence& a, Sequence& b, double diagonal) {
  constexpr int perInterval = 6, margin = 4;
  const int samples = perInterval * (static_cast<int>(a.motion().keyTimes().size()) - 1);
  const auto [start, end] = a.range();
  Difference found;
  for (int i = -margin; i <= samples + margin; ++i) {
    const double t = start + (end - start) * i / samples;
    const Positions x = shapeAt(a, t), y = shapeAt(b, t);
    const double worst = 100 * largestDistance(x, y) / diagonal;
    if (i < 0 || i > samples) {
      found.beyond = std::max(found.beyond, worst);
      continue;
    }
    double sum = 0;
    for (std::size_t v = 0; v < x.size(); ++v) sum += (x[v] - y[v]).norm();
    found.mean = std::max(found.mean, 100 * sum / static_cast<double>(x.size()) / diagonal);
    found.worst = std::max(found.worst, worst);
  }
  return found;
}

// Whether there is a warning about ambiguous rotations.
bool warnsOfTurns(const Sequence& sequence) {
  return std::any_of(sequence.warnings().begin(), sequence.warnings().end(),
                     [](const Warning& w) { return w.code.starts_with("ambiguous-") || w.code == "open-beyond-keys"; });
}

// Without a warning, noise grows by a factor of at most 1,000 in the mean, 10,000 at single vertices and 30,000 beyond
// the keys. The linear motion of faces amplifies the noise by up to 50.
void checkNoise(const std::string& name, const Keyframes& k, int draws, const std::vector<double>& sizes,
                const EncodingOptions& encoding = doublePrecision(), const MotionOptions& motion = {}) {
  const double diagonal = diagonalOf(k);
  Sequence sequence = sequenceOf(k, encoding, motion);
  const bool warns = warnsOfTurns(sequence);
  for (const double size : sizes)
    for (int draw = 0; draw < draws; ++draw) {
      Sequence other = sequenceOf(noisy(k, size, 100 + draw), encoding, motion);
      const Difference d = difference(sequence, other, diagonal);
      MESSAGE("NOISE | " << name << " | " << size << " of the diagonal | mean " << d.mean << " %, worst " << d.worst
                         << " %, beyond " << d.beyond << " % | " << std::string(warns ? "warned" : "not warned"));
      if (warns) continue;
      const double thousandfold = 100 * 1000 * size;
      CHECK(d.mean <= thousandfold);
      CHECK(d.worst <= 10 * thousandfold);
      CHECK(d.beyond <= 30 * thousandfold);
    }
}

// The same with a ghost mesh, held and pinned.
void checkNoiseOfOptions(const std::string& name, const Keyframes& k, int draws) {
  EncodingOptions ghost = doublePrecision();
  ghost.ghostFaces = k.faceCount() / 5;
  MotionOptions held, pinned, closed;
  held.hold = true;
  pinned.pins = everyPin(k);
  closed.boundary = BoundaryKind::Periodic;
  checkNoise(name + ", ghost", k, draws, {1e-6}, ghost);
  checkNoise(name + ", held", k, draws, {1e-6}, doublePrecision(), held);
  checkNoise(name + ", pinned", k, draws, {1e-6}, doublePrecision(), pinned);
  checkNoise(name + ", closed", k, draws, {1e-6}, doublePrecision(), closed);
}

std::vector<std::string> codesOf(const Keyframes& k) {
  const Sequence sequence = sequenceOf(k, doublePrecision());
  std::vector<std::string> found;
  for (const Warning& w : sequence.warnings()) found.push_back(w.code);
  return found;
}

// A bar whose middle is twisted within less than its width.
Keyframes wrungBar(const std::vector<double>& degrees) {
  std::vector<Map> maps;
  for (const double d : degrees)
    maps.push_back([=](const Vec3& p) -> Vec3 {
      const double w = std::clamp((p.z() - 5) / 0.8 + 0.5, 0.0, 1.0);
      return turn(Vec3::UnitZ(), radians(d) * w * w * (3 - 2 * w))(p);
    });
  return keyframes(box(1, 1.2, 10, 4, 5, 45), maps);
}

}  // namespace

TEST_CASE("reversed keys give the reversed motion") {
  for (const Keyframes& k : {poses(), limb(104, 4, 45, 30), limb(130, 5, 140, 100)})
    for (const Method method : {Method::Lri, Method::RotationStrain, Method::Rimd})
      for (const int ghost : {0, 100}) {
        if (method == Method::Lri ? k.faceCount() > 500 : ghost > 0) continue;
        for (const BoundaryKind boundary : {BoundaryKind::Natural, BoundaryKind::Hermite, BoundaryKind::Periodic}) {
          CAPTURE(int(method));
          CAPTURE(int(boundary));
          CAPTURE(ghost);
          MotionOptions motion;
          motion.method = method;
          motion.boundary = boundary;
          EncodingOptions encoding = doublePrecision(), mirrored = doublePrecision();
          encoding.ghostFaces = mirrored.ghostFaces = ghost;
          mirrored.reference = k.keyCount() - 1;
          Sequence forward = sequenceOf(k, encoding, motion), back = sequenceOf(reversed(k), mirrored, motion);
          const double start = k.keys.front().time, end = k.keys.back().time;
          for (const double share : {-0.2, 0.1, 0.3, 0.55, 0.8, 0.95, 1.2}) {
            const double t = start + share * (end - start);
            if (method != Method::Lri && (share < -0.1 || share > 1)) continue;
            CHECK(largestDistance(shapeAt(forward, t), shapeAt(back, start + end - t)) < 5e-4 * diagonalOf(k));
          }
        }
      }
}

TEST_CASE("half as many patches hardly change the paths of limbs") {
  for (const unsigned seed : {115u, 130u, 143u}) {
    CAPTURE(seed);
    const Keyframes k = limb(seed, 3 + seed % 3, 140, 100);
    EncodingOptions encoding = doublePrecision();
    Sequence sequence = sequenceOf(k, encoding);
    encoding.patches = sequence.stats().patches / 2;
    Sequence coarse = sequenceOf(k, encoding);
    const Difference d = difference(sequence, coarse, diagonalOf(k));
    MESSAGE("HALF THE PATCHES | seed " << seed << " | mean " << d.mean << " %, worst " << d.worst << " %");
    CHECK(d.mean < 3);
    CHECK(d.worst < 7);
  }
}

TEST_CASE("noise of a millionth of the diagonal has no visible effect") {
  checkNoise("a bent and twisted box", poses(), 1, {1e-6});
  const Keyframes k = limb(104, 4, 45, 30);
  checkNoise("a limb", k, 1, {1e-6, 1e-4});
  checkNoiseOfOptions("a limb", k, 1);
}

TEST_CASE("noise in real poses" * dense) {
  const std::vector<double> sizes = {1e-7, 1e-6, 1e-5, 1e-4};
  const std::vector<std::vector<std::string>> sets = {
      wolfPoses,
      {"cactus/cactus-1.glb", "cactus/cactus-2.glb", "cactus/cactus-3.glb"},
      {"turns/saddle/monkey_saddle_1.ply", "turns/saddle/monkey_saddle_2.ply"},
      {"turns/plate/plate121.ply", "turns/plate/plate121_rolledA.ply", "turns/plate/plate121_rolledB.ply"},
      {"turns/cat/cat2.off", "turns/cat/cat5.off", "turns/cat/cat8.off"},
      lionPoses,
  };
  for (const std::vector<std::string>& files : sets)
    if (hasData(files)) checkNoise(files.front(), realKeyframes(files), 10, sizes);
}

TEST_CASE("noise in real poses with a ghost mesh, held, pinned and closed" * dense) {
  const std::vector<std::string> cactus = {"cactus/cactus-1.glb", "cactus/cactus-2.glb", "cactus/cactus-3.glb"};
  for (const std::vector<std::string>& files : {wolfPoses, cactus})
    if (hasData(files)) checkNoiseOfOptions(files.front(), realKeyframes(files), 3);
}

TEST_CASE("the winding of the triangles changes nothing") {
  for (const Keyframes& k : {poses(), limb(103, 4, 100, 100)})
    for (const int ghost : {0, 200}) {
      CAPTURE(ghost);
      Keyframes flipped = k;
      for (Triangle& t : flipped.faces) std::swap(t[1], t[2]);
      EncodingOptions encoding = doublePrecision();
      encoding.ghostFaces = ghost;
      Sequence one = sequenceOf(k, encoding), other = sequenceOf(flipped, encoding);
      for (const double share : {-0.2, 0.3, 0.8, 1.2}) {
        const double t = share * k.keys.back().time;
        CHECK(largestDistance(shapeAt(one, t), shapeAt(other, t)) < 1e-9 * diagonalOf(k));
      }
      const std::vector<Triangle>& a = one.encoded().lri().ghost().faces;
      const std::vector<Triangle>& b = other.encoded().lri().ghost().faces;
      REQUIRE(a.size() == b.size());
      for (std::size_t f = 0; f < a.size(); ++f) CHECK(a[f] == Triangle{b[f][0], b[f][2], b[f][1]});
    }
}

TEST_CASE("evenly rotating parts determine the rotation of the whole") {
  // A body that turns evenly, and an arm of three times its area that swings about the same joint.
  const Shape body = box(1, 1, 4, 2, 2, 8);
  Shape arm = box(1.5, 1.5, 6, 3, 3, 12);
  const Vec3 joint(0, 0, 4.1);
  for (Vec3& p : arm.positions) p += joint + Vec3(0, 0, 0.1);
  std::vector<Map> maps;
  for (int j = 0; j < 5; ++j)
    maps.push_back([=](const Vec3& p) -> Vec3 {
      const Map swing = turn(Vec3::UnitY(), radians(j % 2 == 1 ? 60 : 0));
      return turn(Vec3::UnitX(), radians(25 * j))(p.z() > joint.z() ? Vec3(swing(p - joint) + joint) : p);
    });
  Sequence sequence = sequenceOf(keyframes(joined(body, arm), maps, {0, 1, 2, 3, 4}), doublePrecision());
  for (const double t : {0.5, 1.5, 2.5, 3.5}) {
    Positions p = shapeAt(sequence, t);
    p.resize(body.positions.size());
    const Mat3 missed = expRotation(Vec3::UnitX() * -radians(25 * t)) * fitRigid(body.positions, p).rotation;
    CHECK(logRotation(missed).norm() < radians(2.5));  // 4.2 degrees where only areas count
  }
}

TEST_CASE("two turn directions that are about equally good give a warning") {
  const Shape shape = bar();
  for (const double degrees : {163.0, 174.0}) {
    // The mean turn is smaller: one end continues, the other stays behind.
    const Map turned = turn(Vec3::UnitX(), radians(degrees));
    const Keyframes k = keyframes(shape, {bend(0), [=](const Vec3& p) { return turned(twist(radians(100))(p)); }});
    CHECK(codesOf(k) == std::vector<std::string>{"ambiguous-turn"});
  }
  CHECK(codesOf(twistedBar({0, 180, 350})).empty());
  CHECK(codesOf(bentBar({0, 120, -60, 60})).empty());
  CHECK(codesOf(limb(104, 4, 60, 40)).empty());
}

TEST_CASE("a warning states beyond which keys noise has an effect") {
  const std::vector<std::string> both = {"open-beyond-keys", "open-beyond-keys"};
  CHECK(codesOf(wrungBar({0, 140, 0, -140})) == both);
  CHECK(codesOf(wrungBar({0, 30, 0, -30})).empty());
  const Sequence sequence = sequenceOf(wrungBar({0, 140, 0, -140}), doublePrecision());
  CHECK(sequence.warnings()[0].key == 0);
  CHECK(sequence.warnings()[1].key == 3);
  CHECK(sequence.warnings()[1].face >= 0);
  MotionOptions closed;
  closed.boundary = BoundaryKind::Periodic;
  CHECK(sequenceOf(wrungBar({0, 140, 0, -140}), doublePrecision(), closed).warnings().empty());
}

}  // namespace shapespline::test::continuity_test
