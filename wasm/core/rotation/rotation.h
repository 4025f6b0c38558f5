// SO(3): exponential and logarithm, representatives of a logarithm, means. A rotation vector is axis times angle in
// radians.
#pragma once

#include <numbers>

#include <Eigen/Geometry>

#include "core/base/types.h"

namespace shapespline {

using Quaternion = Eigen::Quaterniond;

inline constexpr double twoPi = 2 * std::numbers::pi;

/// Agreement of two rotations that differ by this angle: (1 + cos angle) / 2, and 0 from half a turn on.
double agreement(double angle);

/// exp of a rotation vector (Rodrigues).
Mat3 expRotation(const Vec3& rotationVector);
Quaternion expQuaternion(const Vec3& rotationVector);

/// Principal logarithm: angle in [0, pi]. Accurate near 0 and near pi.
Vec3 logRotation(const Mat3& rotation);
Vec3 logRotation(const Quaternion& rotation);

/// The representative (angle + 2 pi k) about the axis of `rotationVector` that is nearest to `target`. A rotation
/// vector of (nearly) zero angle has no axis and takes the target's.
Vec3 nearestRepresentative(const Vec3& rotationVector, const Vec3& target);

/// Adds `turns` full turns about the rotation vector's axis, or about `fallbackAxis` if it is zero.
Vec3 addTurns(const Vec3& rotationVector, int turns, const Vec3& fallbackAxis);

/// Between two keys, larger rotations are ambiguous in direction and number of turns. Radians.
inline constexpr double ambiguousTurn = 150 * std::numbers::pi / 180;

/// Accumulates weighted rotations. Their mean minimises sum w |R - G|_F^2 over SO(3), which is the projection of the
/// mean matrix. Stored as sum w q q^T, whose leading eigenvector is that mean (Davenport's q-method).
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
