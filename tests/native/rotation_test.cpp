#include <doctest/doctest.h>

#include <algorithm>
#include <numbers>
#include <numeric>
#include <random>

#include <Eigen/Dense>

#include "core/patches/patch_motion.h"
#include "dense.h"

namespace shapespline::test::rotation_test {

namespace {

constexpr double pi = std::numbers::pi;

// Uniform direction. The standard library's distributions differ between compilers, and the cases would differ too.
Vec3 randomVector(std::mt19937& random, double length) {
  const auto coordinate = [&] { return std::ldexp(static_cast<double>(random()), -31) - 1; };
  for (;;) {
    const double x = coordinate(), y = coordinate(), z = coordinate();
    const double norm = Vec3(x, y, z).norm();
    if (norm > 0.1 && norm < 1) return Vec3(x, y, z) * (length / norm);
  }
}

}  // namespace

TEST_CASE("log inverts exp from tiny angles to half a turn") {
  std::mt19937 random(1);
  for (const double angle : {0.0, 1e-12, 1e-8, 1e-4, 0.3, 1.5, 3.0, pi - 1e-3, pi - 1e-7}) {
    const Vec3 v = randomVector(random, angle);
    CHECK((logRotation(expRotation(v)) - v).norm() < 1e-8);
    CHECK((expRotation(v) * expRotation(v).transpose() - Mat3::Identity()).norm() < 1e-14);
  }
}

TEST_CASE("exp agrees with Eigen at every angle, with and without its series") {
  std::mt19937 random(4);
  for (const double angle : {1e-9, 0.01, 0.5, 1.0, 1.9, 2.0, std::nextafter(2.0, 3.0), 2.1, 3.0, 7.0, 40.0})
    for (int i = 0; i < 50; ++i) {
      const Vec3 v = randomVector(random, angle);
      const Quaternion expected(Eigen::AngleAxisd(angle, v.normalized()));
      CHECK((expQuaternion(v).coeffs() - expected.coeffs()).norm() < 1e-15 * std::max(1.0, angle));
    }
  CHECK(expQuaternion(Vec3::Zero()).coeffs() == Quaternion::Identity().coeffs());
}

TEST_CASE("representatives differ by full turns and are nearest to the target") {
  std::mt19937 random(2);
  for (int i = 0; i < 200; ++i) {
    const Vec3 v = randomVector(random, 3 * std::generate_canonical<double, 53>(random));
    const Vec3 target = randomVector(random, 20 * std::generate_canonical<double, 53>(random));
    const Vec3 best = nearestRepresentative(v, target);
    CHECK((expRotation(best) - expRotation(v)).norm() < 1e-9);
    for (int k = -5; k <= 5; ++k) CHECK((best - target).norm() <= (addTurns(v, k, v) - target).norm() + 1e-12);
  }
  const Vec3 turn(0, 0, 2 * pi + 0.2);  // a rotation by zero takes the target's axis
  CHECK((nearestRepresentative(Vec3::Zero(), turn) - Vec3(0, 0, 2 * pi)).norm() < 1e-12);
}

TEST_CASE("the mean of rotations is the projection of their mean matrix") {
  std::mt19937 random(3);
  for (int i = 0; i < 50; ++i) {
    RotationMean mean;
    Mat3 sum = Mat3::Zero();
    for (int k = 0; k < 5; ++k) {
      const Vec3 v = randomVector(random, 1.2);
      mean.add(expQuaternion(v), k + 1);
      sum += (k + 1) * expRotation(v);
    }
    const Eigen::JacobiSVD<Mat3> svd(sum, Eigen::ComputeFullU | Eigen::ComputeFullV);
    Mat3 byDecomposition = svd.matrixU() * svd.matrixV().transpose();
    if (byDecomposition.determinant() > 0) CHECK((mean.mean().toRotationMatrix() - byDecomposition).norm() < 1e-9);
    CHECK((projectToRotation(sum) - mean.mean().toRotationMatrix()).norm() < 1e-9);
  }
}

namespace {

// A single rotation spline through the keys.
RotationSplines pathThrough(const std::vector<Quaternion>& keys) {
  RotationSplines paths;
  for (const Quaternion& q : keys) paths.key.push_back({q});
  for (std::size_t j = 1; j < keys.size(); ++j)
    paths.increment.push_back({logRotation(Quaternion(keys[j - 1].conjugate() * keys[j]))});
  paths.finish(KeySteps{static_cast<int>(keys.size())});
  return paths;
}

Quaternion at(const RotationSplines& paths, const CurvePoint& point) {
  std::vector<Quaternion> rotation;
  paths.at(point, {}, rotation);
  return rotation[0];
}

// A closed ring of patches, defined by their rotations in three keys.
struct Ring {
  WeldedShape shape;
  std::optional<PatchMotion> motion;

  Ring(const std::vector<std::vector<Quaternion>>& rotation) {
    const int count = static_cast<int>(rotation[0].size());
    shape.keys = static_cast<int>(rotation.size());
    shape.poses.resize(shape.keys);
    PatchCoordinates patches;
    patches.rotation = rotation;
    patches.patches.count = count;
    std::vector<PatchLink> links;
    for (int i = 0; i < count; ++i) {
      const int a = std::min(i, (i + 1) % count), b = std::max(i, (i + 1) % count);
      patches.patches.pairs.push_back({a, b, 1});
      links.push_back({a, b, 1});
    }
    REQUIRE(encodeConnections(shape, links, std::vector<double>(count, 1), patches).ok());
    auto made = PatchMotion::create(shape, std::move(patches));
    REQUIRE(made.ok());
    motion = std::move(*made);
  }

  std::vector<Quaternion> at(const CurvePoint& point) {
    LocalFrames frames;
    PatchMotion::Scratch scratch;
    motion->at(point, motion->addedTurns(shape, {}), scratch, frames);
    return frames.rotation;
  }
};

double largestAngle(const std::vector<Quaternion>& a, const std::vector<Quaternion>& b) {
  double largest = 0;
  for (std::size_t k = 0; k < a.size(); ++k) largest = std::max(largest, a[k].angularDistance(b[k]));
  return largest;
}

}  // namespace

TEST_CASE("a rotation path passes through its keys and is the geodesic between two") {
  std::mt19937 random(4);
  std::vector<Quaternion> keys;
  for (int j = 0; j < 4; ++j) keys.push_back(expQuaternion(randomVector(random, 2)));
  const RotationSplines path = pathThrough(keys);
  const Curve curve = std::move(*Curve::fit({0, 1, 2.5, 3}, {}));
  int j = 0;
  for (double t : {0.0, 1.0, 2.5, 3.0}) CHECK(at(path, curve.at(t)).angularDistance(keys[j++]) < 1e-12);
  const RotationSplines two = pathThrough({keys[0], keys[1]});
  const Curve line = std::move(*Curve::fit({0, 1}, {}));
  const Vec3 increment = logRotation(Quaternion(keys[0].conjugate() * keys[1]));
  CHECK(at(two, line.at(0.3)).angularDistance(keys[0] * expQuaternion(0.3 * increment)) < 1e-12);
}

TEST_CASE("a rotation path through many keys is the same if it continues from the last finished key") {
  std::mt19937 random(6);
  std::vector<Quaternion> keys = {Quaternion::Identity()};
  for (int j = 1; j < 100; ++j) keys.push_back(keys.back() * expQuaternion(randomVector(random, 1)));
  const RotationSplines path = pathThrough(keys);
  std::vector<double> times(100);
  std::iota(times.begin(), times.end(), 0);
  const Curve curve = std::move(*Curve::fit(times, {}));
  for (const double t : {3.3, 50.7, 97.2, 103.0}) {
    const CurvePoint point = curve.at(t);
    CHECK(point.steps.size() <= 45);
    CurvePoint whole;
    for (int s = 0; s < 99; ++s) whole.steps.push_back({s, point.weights.segment(s + 1, 99 - s).sum(), 0});
    CHECK(at(path, point).angularDistance(at(path, whole)) < 1e-10);
  }
}

TEST_CASE("a rotation path through reversed keys is the reversed path") {
  std::mt19937 random(7);
  std::vector<Quaternion> keys;
  for (int j = 0; j < 5; ++j) keys.push_back(expQuaternion(randomVector(random, 2)));
  const std::vector<Quaternion> reversed(keys.rbegin(), keys.rend());
  const RotationSplines path = pathThrough(keys), back = pathThrough(reversed);
  const Curve curve = std::move(*Curve::fit({0, 1, 2.5, 3, 5}, {}));
  const Curve mirrored = std::move(*Curve::fit({0, 2, 2.5, 4, 5}, {}));
  for (const double t : {-1.0, 0.3, 1.7, 2.8, 4.1, 6.0})
    CHECK(at(path, curve.at(t)).angularDistance(at(back, mirrored.at(5 - t))) < 1e-12);
}

namespace {

// The chosen turns about z, in degrees.
std::vector<double> chosenDegrees(const std::vector<double>& degrees) {
  std::vector<TurnOptions> options;
  for (const double d : degrees) options.push_back(turnOptions(Vec3(0, 0, d * pi / 180)));
  const std::vector<char> other = chooseTurns(options);
  std::vector<double> chosen;
  for (std::size_t s = 0; s < options.size(); ++s)
    chosen.push_back(std::round((other[s] ? options[s].other : options[s].turn).z() * 180 / pi));
  return chosen;
}

}  // namespace

TEST_CASE("half turns continue in the same direction, from either end") {
  CHECK(chosenDegrees({-180, 180, -180}) == std::vector<double>{180, 180, 180});
  CHECK(chosenDegrees({100, -179.9999}) == std::vector<double>{100, 180});
  CHECK(chosenDegrees({-179.9999, 100}) == std::vector<double>{180, 100});
  CHECK(chosenDegrees({90, -178, 90}) == std::vector<double>{90, 182, 90});
}

TEST_CASE("the shorter rotation is taken unless it is hardly shorter") {
  CHECK(chosenDegrees({100, -120, 100}) == std::vector<double>{100, -120, 100});
  CHECK(chosenDegrees({155, -155}) == std::vector<double>{155, -155});
  CHECK(chosenDegrees({170, -170}) == std::vector<double>{170, 190});
}

TEST_CASE("patch rotations: consistent connections are satisfied, others have a small effect") {
  std::mt19937 random(5);
  const int count = 60;  // a closed band with many cycles
  std::vector<PatchLink> links;
  for (int i = 0; i < count; ++i)
    for (const int j : {(i + 1) % count, (i + 2) % count}) links.push_back({i, j, 1});
  const PatchGraph graph(links, std::vector<double>(count, 1));
  const std::vector<double> weight(links.size(), 0.7);
  const auto system =
      PatchRotationSystem::create(graph, graph.centreTree(std::vector<double>(links.size(), 1)), weight);
  REQUIRE(system.ok());
  PatchRotationSystem::Scratch scratch;
  std::vector<Quaternion> wanted, found;
  for (int i = 0; i < count; ++i) wanted.push_back(expQuaternion(randomVector(random, 1)));
  for (const double disagreement : {0.0, 0.05}) {
    std::vector<Quaternion> connection;
    for (const auto& [i, j, edges] : links)
      connection.push_back(wanted[i].conjugate() * wanted[j] * expQuaternion(randomVector(random, disagreement)));
    system->solve(connection, std::array{1, 1}, scratch, found);
    double squares = 0, treeSquares = 0;
    const auto residual = [&](std::size_t l) {
      return found[links[l].to].angularDistance(found[links[l].from] * connection[l]);
    };
    for (std::size_t l = 0; l < links.size(); ++l) squares += std::pow(residual(l), 2);
    system->solve(connection, {}, scratch, found);
    for (std::size_t l = 0; l < links.size(); ++l) treeSquares += std::pow(residual(l), 2);
    if (disagreement == 0) CHECK(std::sqrt(squares) < 1e-10);
    else CHECK(squares < 0.7 * treeSquares);
  }
}

// The maps disagree around the ring between the keys. An iteration to convergence would lose its minimum and jump to
// another.
TEST_CASE("a ring of patches that turn by 170 degrees against each other turns without a jump" * dense) {
  double worst = 0;
  for (unsigned seed = 0; seed < 200; ++seed) {
    std::mt19937 random(seed);
    const std::vector<Quaternion> still(8, Quaternion::Identity());
    std::vector<Quaternion> turned = still;
    for (int i = 1; i < 8; ++i)
      turned[i] = turned[i - 1] * expQuaternion(randomVector(random, 1).normalized() * (170 * pi / 180));
    Ring ring({still, turned, still});
    const Curve curve = std::move(*Curve::fit({0, 1, 2}, {}));
    std::vector<double> steps;
    std::vector<Quaternion> before = ring.at(curve.at(0));
    for (int i = 1; i <= 2000; ++i) {
      std::vector<Quaternion> now = ring.at(curve.at(i / 1000.0));
      steps.push_back(largestAngle(before, now));
      before = std::move(now);
    }
    std::nth_element(steps.begin(), steps.begin() + 1000, steps.end());
    worst = std::max(worst, *std::max_element(steps.begin(), steps.end()) / steps[1000]);
    CHECK(largestAngle(ring.at(curve.at(1)), turned) < 1e-10);
  }
  MESSAGE("largest over median step, worst of 200 rings: " << worst);
  CHECK(worst < 6);
}

}  // namespace shapespline::test::rotation_test
