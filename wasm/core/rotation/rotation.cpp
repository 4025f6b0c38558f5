#include "core/rotation/rotation.h"

#include <cmath>
#include <numbers>

#include <Eigen/Eigenvalues>

#include "core/rotation/rotation_series.h"

namespace shapespline {

namespace {

// Below this angle the axis of a rotation vector is rounding noise (about the square root of double's epsilon).
constexpr double axisEpsilon = 1e-8;

// Up to one radian, nine terms of the series in half the angle are exact to rounding, at a third of the cost of the C
// library's sine and cosine.
constexpr double seriesLimit = 1;

Quaternion leadingEigenvector(const Eigen::Matrix4d& symmetric) {
  const Eigen::SelfAdjointEigenSolver<Eigen::Matrix4d> solver(symmetric);
  Quaternion q;
  q.coeffs() = solver.eigenvectors().col(3);
  return q.normalized();
}

}  // namespace

double agreement(double angle) {
  const double half = std::cos(std::min(angle, std::numbers::pi) / 2);
  return half * half;
}

Quaternion expQuaternion(const Vec3& v) {
  const double x = v.squaredNorm() / 4;  // half the angle, squared
  if (x <= seriesLimit) {
    const double s = 0.5 * horner<9>(rotationSeries.sine, x);
    return Quaternion(1 - x * horner<9>(rotationSeries.cosine, x), s * v.x(), s * v.y(), s * v.z());
  }
  const double half = std::sqrt(x), s = std::sin(half) / (2 * half);
  return Quaternion(std::cos(half), s * v.x(), s * v.y(), s * v.z());
}

Mat3 expRotation(const Vec3& v) { return expQuaternion(v).normalized().toRotationMatrix(); }

Vec3 logRotation(const Quaternion& q) {
  const double sign = q.w() < 0 ? -1 : 1;
  const double sine = q.vec().norm();
  const double cosine = sign * q.w();
  // angle / sin(angle / 2); the limit is 2
  const double factor = sine < 1e-9 ? 2 / cosine : 2 * std::atan2(sine, cosine) / sine;
  return sign * factor * q.vec();
}

Vec3 logRotation(const Mat3& rotation) { return logRotation(Quaternion(rotation)); }

Vec3 nearestRepresentative(const Vec3& v, const Vec3& target) {
  const double angle = v.norm();
  if (angle < axisEpsilon) {
    const double reach = target.norm();
    const double turns = std::round(reach / twoPi);
    return turns == 0 ? v : Vec3(v + target * (turns * twoPi / reach));
  }
  const Vec3 axis = v / angle;
  const double turns = std::round((target.dot(axis) - angle) / twoPi);
  return v + axis * (turns * twoPi);
}

Vec3 addTurns(const Vec3& v, int turns, const Vec3& fallbackAxis) {
  if (turns == 0) return v;
  const double angle = v.norm();
  const Vec3 axis = angle < axisEpsilon ? fallbackAxis.normalized() : Vec3(v / angle);
  return v + axis * (turns * twoPi);
}

void RotationMean::add(const Quaternion& q, double weight) {
  outer_.noalias() += weight * q.coeffs() * q.coeffs().transpose();
}

Quaternion RotationMean::mean() const {
  return outer_.trace() > 0 ? leadingEigenvector(outer_) : Quaternion::Identity();
}

Mat3 projectToRotation(const Mat3& m) {
  // Davenport's matrix of the linear form tr(R^T M) = q^T K q.
  Eigen::Matrix4d k;
  const double trace = m.trace();
  k.topLeftCorner<3, 3>() = m + m.transpose() - trace * Mat3::Identity();
  const Vec3 skew(m(2, 1) - m(1, 2), m(0, 2) - m(2, 0), m(1, 0) - m(0, 1));
  k.topRightCorner<3, 1>() = skew;
  k.bottomLeftCorner<1, 3>() = skew.transpose();
  k(3, 3) = trace;
  return leadingEigenvector(k).toRotationMatrix();
}

}  // namespace shapespline
