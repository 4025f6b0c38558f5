// Quadratic error forms for edge collapses (Garland and Heckbert 1997). Each is stored relative to its own vertex to
// avoid cancellation: errors of a fine mesh are 1e-9 of its size.
#pragma once

#include "core/base/types.h"

namespace shapespline {

/// q(d) = d^T A d + 2 b^T d + c for the offset d from the form's vertex.
struct Quadric {
  double xx = 0, xy = 0, xz = 0, yy = 0, yz = 0, zz = 0;  // A
  double x = 0, y = 0, z = 0;                             // b
  double c = 0;

  /// Adds the squared distance from a plane through the vertex. normal: unit.
  void addPlane(const Vec3& normal, double weight) {
    const Vec3 w = weight * normal;
    xx += w.x() * normal.x();
    xy += w.x() * normal.y();
    xz += w.x() * normal.z();
    yy += w.y() * normal.y();
    yz += w.y() * normal.z();
    zz += w.z() * normal.z();
  }

  /// Adds the squared distance from the vertex itself.
  void addPoint(double weight) {
    xx += weight;
    yy += weight;
    zz += weight;
  }

  double at(const Vec3& d) const {
    return d.x() * (xx * d.x() + 2 * (xy * d.y() + xz * d.z() + x)) + d.y() * (yy * d.y() + 2 * (yz * d.z() + y)) +
           d.z() * (zz * d.z() + 2 * z) + c;
  }

  /// This form relative to the point at offset d.
  Quadric about(const Vec3& d) const {
    Quadric moved = *this;
    moved.x += xx * d.x() + xy * d.y() + xz * d.z();
    moved.y += xy * d.x() + yy * d.y() + yz * d.z();
    moved.z += xz * d.x() + yz * d.y() + zz * d.z();
    moved.c = at(d);
    return moved;
  }

  Quadric& operator+=(const Quadric& o) {
    xx += o.xx;
    xy += o.xy;
    xz += o.xz;
    yy += o.yy;
    yz += o.yz;
    zz += o.zz;
    x += o.x;
    y += o.y;
    z += o.z;
    c += o.c;
    return *this;
  }

  /// The offset with the smallest error; zero if A is singular.
  Vec3 minimiser() const {
    const Vec3 a(xx, xy, xz), b(xy, yy, yz), e(xz, yz, zz), right(-x, -y, -z);
    const Vec3 bc = b.cross(e);
    const double determinant = a.dot(bc);
    if (!(determinant > 1e-12 * xx * yy * zz)) return Vec3::Zero();
    return Vec3(right.dot(bc), a.dot(right.cross(e)), a.dot(b.cross(right))) / determinant;
  }
};

}  // namespace shapespline
