// Parts that are one point in some key, and keys far apart.
#include <doctest/doctest.h>

#include "core/mesh/weld.h"
#include "sequences.h"
#include "shapes.h"

namespace shapespline::test::loose_parts_test {

namespace {

std::vector<const Positions*> posesOf(const Keyframes& k) {
  std::vector<const Positions*> poses;
  for (const Key& key : k.keys) poses.push_back(&key.positions);
  return poses;
}

int weldedCount(const Keyframes& k) {
  const auto poses = posesOf(k);
  return weld(poses, weldTolerances(poses)).count;
}

Keyframes inFloat32(Keyframes k) {
  for (Key& key : k.keys)
    for (Vec3& p : key.positions) p = p.cast<float>().cast<double>();
  return k;
}

/// Cuts along every edge: each face has three vertices of its own, within rounding of its neighbours'.
Shape cutApart(const Shape& shape) {
  Shape apart;
  for (const Triangle& t : shape.faces) {
    const int first = static_cast<int>(apart.positions.size());
    for (int v : t) apart.positions.push_back(shape.positions[v] * (1 + 1e-8 * (first % 7)));
    apart.faces.push_back({first, first + 1, first + 2});
  }
  return apart;
}

}  // namespace

TEST_CASE("a distant key welds the same vertices as at the origin") {
  Shape fine = box(1, 1, 2, 20, 20, 40);
  fine = joined(fine, sphere({0.6, 0, 1}, 1e-4));  // small, but larger than the weld tolerance
  const auto n = static_cast<int>(fine.positions.size());
  for (const Shape& shape : {fine, cutApart(fine)}) {
    Keyframes k = keyframes(shape, {bend(0), bend(1), bend(-1)});
    CHECK(weldedCount(k) == n);
    for (Vec3& p : k.keys[1].positions) p += Vec3(9000, -2000, 500);
    CHECK(weldedCount(k) == n);
    CHECK(weldedCount(inFloat32(k)) == n);
  }
}

TEST_CASE("a key or a part that is one point does not affect the seams of others") {
  const Shape body = box(1, 1, 2, 4, 4, 8);
  const Keyframes k = keyframes(cutApart(body), {[](const Vec3&) -> Vec3 { return {1, 2, 3}; }, bend(0), bend(1)});
  CHECK(weldedCount(k) == static_cast<int>(body.positions.size()));
}

TEST_CASE("a welded vertex is in the middle of its copies, in any order") {
  const Positions copies = {{1, 2, 3}, {1 + 3e-7, 2, 3}, {0, 0, 0}, {1, 2, 3 - 6e-7}};
  const Positions turned(copies.rbegin(), copies.rend());
  for (const Positions* pose : {&copies, &turned}) {
    const Welding welding = weld({&pose, 1}, weldTolerances({&pose, 1}));
    REQUIRE(welding.count == 2);
    const Vec3 middle = weldPositions(*pose, welding)[welding.weldedOfRaw[0]];
    CHECK((middle - Vec3(1 + 1e-7, 2, 3 - 2e-7)).norm() < 1e-15);
  }
}

TEST_CASE("a hat that is one point in some key stays in place on the shape") {
  const double radius = 0.3, gap = 0.1;
  const Vec3 foot(0.5, 0, 7.5), middle = foot + Vec3(gap + radius, 0, 0);
  const Shape body = bar(), hat = sphere(middle, radius);
  const Shape both = joined(hat, body);
  const auto map = [&](double degrees, double size) -> Map {
    const Map bending = bend(radians(degrees)), hatTurn = turn(Vec3::UnitY(), radians(0.75 * degrees));
    return [=](const Vec3& p) -> Vec3 {
      if ((p - middle).norm() > 1.001 * radius) return bending(p);
      return bending(foot) + hatTurn(Vec3(middle + size * (p - middle) - foot));
    };
  };
  for (const int ghostFaces : {0, 600}) {
    CAPTURE(ghostFaces);
    EncodingOptions encoding = doublePrecision();
    encoding.ghostFaces = ghostFaces;
    Sequence s = sequenceOf(keyframes(both, {map(0, 1), map(80, 0), map(160, 1)}), encoding);
    const auto hatVertices = static_cast<std::ptrdiff_t>(hat.positions.size());
    std::size_t atFoot = 0;
    for (std::size_t v = 0; v < body.positions.size(); ++v)
      if ((body.positions[v] - foot).norm() < 1e-9) atFoot = hat.positions.size() + v;
    REQUIRE(atFoot > 0);
    for (double t = 0; t <= 1; t += 0.05) {
      const Positions p = shapeAt(s, t);
      Vec3 centre = Vec3::Zero();
      for (std::ptrdiff_t v = 0; v < hatVertices; ++v) centre += p[v] / static_cast<double>(hatVertices);
      CHECK((centre - p[atFoot]).norm() == doctest::Approx(gap + radius).epsilon(0.02));
    }
  }
}

}  // namespace shapespline::test::loose_parts_test
