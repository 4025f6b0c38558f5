// SO(3): exponential and logarithm, representatives of a logarithm, means. Rotation vectors are axis times angle,
// radians.
#pragma once

#include <numbers>

#include <Eigen/Geometry>

#include "core/base/types.h"

namespace shapespline {

using Quaternion = Eigen::Quaterniond;

inline constexpr double twoPi = 2 * std::numbers::pi;

/// How much two rotations have in common that differ by this angle: (1 + cos angle) / 2, and 0 from half a turn on.
double agreement(double angle);

/// exp of a rotation vector (Rodrigues).
Mat3 expRotation(const Vec3& rotationVector);
Quaternion expQuaternion(const Vec3& rotationVector);

/// Principal logarithm: angle in [0, pi]. Accurate near 0 and near pi.
Vec3 logRotation(const Mat3& rotation);
Vec3 logRotation(const Quaternion& rotation);

/// The representative (angle + 2 pi k) about the axis of `rotationVector` that lies nearest `target`. A rotation vector
/// of angle (near) zero has no axis of its own and takes the target's.
Vec3 nearestRepresentative(const Vec3& rotationVector, const Vec3& target);

/// The same rotation vector with `turns` whole turns added about its own axis; about `fallbackAxis` where it is zero.
Vec3 addTurns(const Vec3& rotationVector, int turns, const Vec3& fallbackAxis);

/// Above this the keys leave open which way and how often something turned between them, radians.
inline constexpr double ambiguousTurn = 150 * std::numbers::pi / 180;

/// Accumulates weighted rotations; its mean minimises sum w |R - G|_F^2 over SO(3), that is, the projection of the mean
/// matrix. Kept as sum w q q^T, whose leading eigenvector is that mean (Davenport's q-method).
class RotationMean {
 public:
  void add(const Quaternion& rotation, double weight);
  Quaternion mean() const;

 private:
  Eigen::Matrix4d outer_ = Eigen::Matrix4d::Zero();  // coefficients in the order x, y, z, w
};

/// Nearest rotation to a 3x3 matrix in the Frobenius norm, det = +1.
Mat3 projectToRotation(const Mat3& matrix);

}  // namespace shapespline
