// Detects a key that is a mirror image of the others, without false positives for sheets and poses of real shapes.
#include <doctest/doctest.h>

#include <algorithm>
#include <random>

#include "core/mesh/weld.h"
#include "core/sequence/mirrored_keys.h"
#include "real_data.h"
#include "sequences.h"
#include "shapes.h"

namespace shapespline::test::mirrored_test {

namespace {

const Map mirrorX = [](const Vec3& p) -> Vec3 { return {-p.x(), p.y(), p.z()}; };

Map then(const Map& first, const Map& second) {
  return [=](const Vec3& p) -> Vec3 { return second(first(p)); };
}

WeldedShape weldedOf(const Keyframes& k) {
  std::vector<const Positions*> poses;
  for (const Key& key : k.keys) poses.push_back(&key.positions);
  const Welding welding = weld(poses, weldTolerances(poses));
  WeldedShape shape;
  shape.faces = weldFaces(k.faces, welding);
  for (const Positions* pose : poses) shape.poses.push_back(weldPositions(*pose, welding));
  shape.keys = k.keyCount();
  return shape;
}

std::vector<int> mirroredOf(const Keyframes& k) { return mirroredKeys(weldedOf(k)); }

Keyframes withMirrored(Keyframes k, int key) {
  k.keys[key].positions = mapped(k.keys[key].positions, mirrorX);
  return k;
}

/// The bar with bumps.
Shape bumpyBar() {
  Shape shape = box(1, 1, 10, 6, 6, 60);
  for (Vec3& p : shape.positions)
    p += 0.1 * std::sin(2 * p.z()) * std::cos(3 * p.y()) * Vec3(p.x(), p.y(), 0).normalized();
  return shape;
}

/// A square sheet of side 4 with k x k cells. Corners are off the grid by up to `jitter` cells.
Shape sheet(int k = 30, double jitter = 0) {
  Shape shape;
  std::mt19937 random(1);
  const auto at = [&](int i) { return 4 * (i + jitter * (2.0 * random() / 0x1p32 - 1)) / k - 2; };
  for (int i = 0; i <= k; ++i)
    for (int j = 0; j <= k; ++j) {
      const double x = at(i), y = at(j);
      shape.positions.emplace_back(x, y, 0);
    }
  for (int i = 0; i < k; ++i)
    for (int j = 0; j < k; ++j) {
      const int a = i * (k + 1) + j, b = a + 1, c = a + k + 2, d = a + k + 1;
      shape.faces.push_back({a, d, b}), shape.faces.push_back({d, c, b});
    }
  return shape;
}

/// Rolls the x axis up to an arc of `angle`.
Map roll(double angle) {
  return [=](const Vec3& p) -> Vec3 {
    const double radius = 4 / angle;
    return {radius * std::sin(p.x() / radius), p.y(), radius * (1 - std::cos(p.x() / radius))};
  };
}

}  // namespace

TEST_CASE("a mirrored key of a ball or a bumpy bar is named, for any key and pose") {
  const Shape ball = sphere({0, 0, 0}, 1);
  CHECK(mirroredOf(keyframes(ball, {turn(Vec3::UnitX(), 0), mirrorX})) == std::vector{1});
  CHECK(mirroredOf(keyframes(ball, {turn(Vec3::UnitX(), 0), turn(Vec3(1, 2, 3), 2)})).empty());
  const Shape shape = bumpyBar();
  CHECK(mirroredOf(keyframes(shape, {bend(0), bend(2), twist(3), bend(-3)})).empty());
  CHECK(mirroredOf(keyframes(shape, {bend(0), bend(2), then(bend(-2), mirrorX), twist(3)})) == std::vector{2});
  CHECK(mirroredOf(keyframes(shape, {then(bend(1), mirrorX), bend(2), twist(3)})) == std::vector{0});
  // A rotated and scaled mirror image is still detected.
  const Map away = [](const Vec3& p) -> Vec3 { return 100 * turn(Vec3(1, 2, 3), 2.2, Vec3(70, 0, 0))(p); };
  CHECK(mirroredOf(keyframes(shape, {bend(0), then(then(twist(2), mirrorX), away)})) == std::vector{1});
}

TEST_CASE("the warning names the key and stays through updates") {
  const Keyframes k = keyframes(bumpyBar(), {bend(0), bend(1), then(bend(2), mirrorX)});
  Sequence s = sequenceOf(k, {});
  const auto check = [&] {
    REQUIRE(!s.warnings().empty());
    CHECK(s.warnings()[0].code == "mirrored-key");
    CHECK(s.warnings()[0].key == 2);
    CHECK(s.warnings()[0].about == "Key");
  };
  check();
  MotionOptions periodic;
  periodic.boundary = BoundaryKind::Periodic;
  REQUIRE(s.update(periodic, evenTimes(3)).ok());
  check();
  Sequence sound = sequenceOf(keyframes(bumpyBar(), {bend(0), bend(1)}), {});
  for (const Warning& warning : sound.warnings()) CHECK(warning.code != "mirrored-key");
}

TEST_CASE("a sheet can roll up to either side") {
  const Shape flat = sheet();
  CHECK(mirroredOf(keyframes(flat, {turn(Vec3::UnitX(), 0), roll(3), roll(-5)})).empty());
  CHECK(mirroredOf(keyframes(flat, {roll(3), roll(-5)})).empty());
  // Irregular triangles on a cylinder have some curvature.
  CHECK(mirroredOf(keyframes(sheet(200, 0.35), {roll(3), roll(-5)})).empty());
}

TEST_CASE("curvature due to noise is ignored") {
  std::mt19937 random(1);
  Shape tube = box(1, 1, 10, 16, 16, 160);  // open at its ends, but not a sheet
  std::erase_if(tube.faces, [&](const Triangle& t) {
    return std::any_of(t.begin(), t.end(),
                       [&](int v) { return tube.positions[v].z() == 0 || tube.positions[v].z() == 10; });
  });
  const Map round = [](const Vec3& p) -> Vec3 {
    const Vec3 across(p.x(), p.y(), 0);
    return Vec3(0, 0, p.z()) + across.normalized();
  };
  Keyframes k = keyframes(tube, {round, then(round, mirrorX)});
  for (Key& key : k.keys)
    for (Vec3& p : key.positions)
      for (double& x : p) x += 2e-3 * (2.0 * random() / 0x1p32 - 1);
  CHECK(mirroredOf(k).empty());
}

TEST_CASE("poses of real shapes: none is mirrored, and each is when it is mirrored") {
  using Paths = std::vector<std::string>;
  struct Set {
    Paths files;
    bool isBody = true;  // not a sheet
  };
  const Set sets[] = {
      {{"cactus/cactus-1.glb", "cactus/cactus-2.glb", "cactus/cactus-3.glb"}},
      {{"morph/Horse.glb"}},
      {{"morph/AnimatedMorphSphere.gltf", "morph/AnimatedMorphSphere.bin"}},
      {{"morph/MorphStressTest.gltf"}},
      {{"skin/CesiumMan.glb"}},
      {{"skin/Fox.glb"}},
      {{"skin/Soldier.glb"}},
      {{"blender/apply_0.glb", "blender/apply_1.glb", "blender/apply_2.glb"}},
      {wolfPoses},
      {{"obj/lowpoly-cat/cat_000001.obj", "obj/lowpoly-cat/cat_000007.obj", "obj/lowpoly-cat/cat_000013.obj",
        "obj/lowpoly-cat/cat_000019.obj", "obj/lowpoly-cat/cat_000025.obj", "obj/lowpoly-cat/cat_000031.obj"}},
      {{"turns/cat/cat2.off", "turns/cat/cat5.off", "turns/cat/cat8.off"}},
      {lionPoses},
      {{"turns/plate/plate121.ply", "turns/plate/plate121_rolledA.ply", "turns/plate/plate121_rolledB.ply"}, false},
      {{"turns/plate/plate121_rolledA.ply", "turns/plate/plate121_rolledB.ply"}, false},
      {{"turns/saddle/monkey_saddle_1.ply", "turns/saddle/monkey_saddle_2.ply"}, false}};
  for (const Set& set : sets) {
    if (!hasData(set.files)) continue;
    CAPTURE(set.files[0]);
    const Keyframes k = realKeyframes(set.files);
    const WeldedShape shape = weldedOf(k);
    double least = 1;
    for (int key = 1; key < k.keyCount(); ++key) least = std::min(least, bulgeAgreement(shape, 0, key));
    MESSAGE(set.files[0] << ": the surface bulges alike to " << least);
    CHECK(mirroredKeys(shape).empty());
    if (!set.isBody) continue;
    const int last = k.keyCount() - 1;
    CHECK(mirroredOf(withMirrored(k, last)) == std::vector{last});
  }
}

}  // namespace shapespline::test::mirrored_test
