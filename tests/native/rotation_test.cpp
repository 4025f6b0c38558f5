#include <doctest/doctest.h>

#include <numbers>
#include <random>

#include <Eigen/Dense>

#include "core/patch_rotations.h"
#include "core/rotation_path.h"

using namespace shapespline;

namespace {

constexpr double pi = std::numbers::pi;

Vec3 randomVector(std::mt19937& random, double length) {
  std::normal_distribution<double> normal;
  return Vec3(normal(random), normal(random), normal(random)).normalized() * length;
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

TEST_CASE("exp is Eigen's at every angle, by its series or not") {
  std::mt19937 random(4);
  for (const double angle : {1e-9, 0.01, 0.5, 1.0, 1.9, 2.0, std::nextafter(2.0, 3.0), 2.1, 3.0, 7.0, 40.0})
    for (int i = 0; i < 50; ++i) {
      const Vec3 v = randomVector(random, angle);
      const Quaternion expected(Eigen::AngleAxisd(angle, v.normalized()));
      CHECK((expQuaternion(v).coeffs() - expected.coeffs()).norm() < 1e-15 * std::max(1.0, angle));
    }
  CHECK(expQuaternion(Vec3::Zero()).coeffs() == Quaternion::Identity().coeffs());
}

TEST_CASE("representatives differ by whole turns and lie nearest the target") {
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

TEST_CASE("the condition of a mean falls to zero for a twist by a whole turn") {
  const auto twistBy = [](double angle) {
    RotationMean mean;
    for (int i = 0; i <= 1000; ++i) mean.add(expQuaternion(Vec3(0, 0, angle * i / 1000)), i % 1000 == 0 ? 0.5 : 1);
    return mean.condition();
  };
  CHECK(twistBy(0) == doctest::Approx(1));
  CHECK(twistBy(pi) == doctest::Approx(std::sin(pi / 2) / (pi / 2)).epsilon(1e-4));
  CHECK(twistBy(2 * pi) < 1e-6);
}

TEST_CASE("a rotation path passes through its keys and is the geodesic between two") {
  std::mt19937 random(4);
  std::vector<Quaternion> keys;
  for (int j = 0; j < 4; ++j) keys.push_back(expQuaternion(randomVector(random, 2)));
  const RotationPath path(keys);
  const Curve curve = std::move(*Curve::fit({0, 1, 2.5, 3}, {}));
  int j = 0;
  for (double t : {0.0, 1.0, 2.5, 3.0}) CHECK(path.at(curve.weights(t)).angularDistance(keys[j++]) < 1e-12);
  const RotationPath two({keys[0], keys[1]});
  const Curve line = std::move(*Curve::fit({0, 1}, {}));
  const Vec3 increment = logRotation(Quaternion(keys[0].conjugate() * keys[1]));
  CHECK(two.at(line.weights(0.3)).angularDistance(keys[0] * expQuaternion(0.3 * increment)) < 1e-12);
}

TEST_CASE("half turns go on in the same sense") {
  const RotationPath path({expQuaternion(Vec3(0, 0, 0)), expQuaternion(Vec3(0, 0, pi)), expQuaternion(Vec3(0, 0, 2 * pi))});
  CHECK((path.increment(1) - path.increment(2)).norm() < 1e-9);
}

TEST_CASE("patch rotations: connections that agree are met, and of others the pulls cancel out") {
  std::mt19937 random(5);
  Patches patches;  // a closed band of triangles, with many cycles
  patches.count = 60;
  patches.pieceOf.assign(patches.count, 0);
  for (int i = 0; i < patches.count; ++i)
    for (const int j : {(i + 1) % patches.count, (i + 2) % patches.count}) patches.pairs.push_back({std::min(i, j), std::max(i, j), 1});
  const std::vector<double> weight(patches.pairs.size(), 0.7);
  PatchRotationSystem system;
  REQUIRE(system.build(patches, weight, 0).ok());
  std::vector<Quaternion> wanted, found;
  for (int i = 0; i < patches.count; ++i) wanted.push_back(expQuaternion(randomVector(random, 1)));
  for (const double disagreement : {0.0, 0.05, 0.3}) {
    std::vector<Vec3> pair;
    for (const auto& [i, j, edges] : patches.pairs)
      pair.push_back(logRotation(Quaternion(wanted[i].conjugate() * wanted[j])) + randomVector(random, disagreement));
    CHECK(system.solve(pair, found) < 20);
    std::vector<Vec3> pull(patches.count, Vec3::Zero());
    double largestError = 0, largestPull = 0;
    for (std::size_t p = 0; p < pair.size(); ++p) {
      const auto& [i, j, edges] = patches.pairs[p];
      const Quaternion error = found[j] * (found[i] * expQuaternion(pair[p])).conjugate();
      largestError = std::max(largestError, error.vec().norm());
      pull[i] += weight[p] * 2 * error.w() * error.vec();
      pull[j] -= weight[p] * 2 * error.w() * error.vec();
    }
    for (const Vec3& sum : pull) largestPull = std::max(largestPull, sum.norm());
    if (disagreement == 0) CHECK(largestError < 1e-10);
    CHECK(largestPull < 1e-10);
  }
}
