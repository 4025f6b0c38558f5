#include "core/rotation/rigid_motion.h"

#include <cmath>

namespace shapespline {

namespace {

Mat3 crossMatrix(const Vec3& v) {
  Mat3 m;
  m << 0, -v.z(), v.y(), v.z(), 0, -v.x(), -v.y(), v.x(), 0;
  return m;
}

// V with exp(w, u) = (exp w, V(w) u): the integral of exp(s w) over s from 0 to 1.
Mat3 meanRotation(const Vec3& w) {
  const double angle = w.norm();
  const Mat3 k = crossMatrix(w);
  if (angle < 1e-4) return Mat3::Identity() + k / 2 + k * k / 6;
  const double squared = angle * angle, half = std::sin(angle / 2);
  return Mat3::Identity() + (2 * half * half / squared) * k + ((angle - std::sin(angle)) / (squared * angle)) * k * k;
}

}  // namespace

RigidMotion RigidMotion::power(double s) const {
  const Vec3 w = logRotation(rotation);
  const Vec3 u = meanRotation(w).partialPivLu().solve(translation);
  return {expQuaternion(s * w), meanRotation(s * w) * (s * u)};
}

}  // namespace shapespline
