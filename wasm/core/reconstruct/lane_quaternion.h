// Quaternions in vector lanes: four rotations at once.
#pragma once

#include "core/base/simd.h"
#include "core/reconstruct/rodrigues.h"
#include "core/rotation/rotation.h"

namespace shapespline {

template <class L>
struct LaneQuaternion {
  L x, y, z, w;
};

template <class L>
LaneQuaternion<L> operator*(const LaneQuaternion<L>& a, const LaneQuaternion<L>& b) {
  return {a.w * b.x + a.x * b.w + a.y * b.z - a.z * b.y, a.w * b.y - a.x * b.z + a.y * b.w + a.z * b.x,
          a.w * b.z + a.x * b.y - a.y * b.x + a.z * b.w, a.w * b.w - a.x * b.x - a.y * b.y - a.z * b.z};
}

template <class L>
LaneQuaternion<L> operator+(const LaneQuaternion<L>& a, const LaneQuaternion<L>& b) {
  return {a.x + b.x, a.y + b.y, a.z + b.z, a.w + b.w};
}

template <class L>
LaneQuaternion<L> conjugate(const LaneQuaternion<L>& q) {
  const L none = L::zero();
  return {none - q.x, none - q.y, none - q.z, q.w};
}

/// [x, y, z, w][lane].
template <class L, class Real>
LaneQuaternion<L> loadRotations(const Real* q) {
  return {L::load(q), L::load(q + faceLanes), L::load(q + 2 * faceLanes), L::load(q + 3 * faceLanes)};
}

template <class L>
LaneQuaternion<L> splat(const Quaternion& q) {
  const auto all = [](double x) { return L::splat(static_cast<typename L::Real>(x)); };
  return {all(q.x()), all(q.y()), all(q.z()), all(q.w())};
}

/// exp of twice these vectors, from sine and cosine of half the angle.
template <class L>
LaneQuaternion<L> expOfHalves(const L& x, const L& y, const L& z) {
  const L squared = x * x + y * y + z * z;
  const auto f = rodrigues<typename L::Real>(squared);
  return {f.a * x, f.a * y, f.a * z, L::splat(1) - squared * f.b};
}

template <class L, class Real>
void storeUnit(const LaneQuaternion<L>& q, Real* to) {
  const L f = L::splat(1) / squareRoot(q.x * q.x + q.y * q.y + q.z * q.z + q.w * q.w);
  (f * q.x).store(to);
  (f * q.y).store(to + faceLanes);
  (f * q.z).store(to + 2 * faceLanes);
  (f * q.w).store(to + 3 * faceLanes);
}

}  // namespace shapespline
