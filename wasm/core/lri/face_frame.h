// One triangle's deformation against the reference pose: R_f and S_f of the deformation gradient (paper section 4.2).
#pragma once

#include "core/base/types.h"
#include "core/mesh/triangle.h"
#include "core/rotation/rotation.h"

namespace shapespline {

/// A triangle of the reference pose in its own tangent frame: t1 along the first edge, t2 in the plane, n the normal.
struct FaceFrame {
  Mat3 basis;  ///< columns t1, t2, n: a rotation
  Mat2 edges;  ///< columns: second and third corner relative to the first, in (t1, t2)
  double area = 0;
};

FaceFrame faceFrame(const Vec3& a, const Vec3& b, const Vec3& c);

/// The area of a triangle times the gradient of a corner's hat function: half the opposite edge, rotated by 90 degrees.
/// opposite: that edge in the tangent plane, counterclockwise.
inline Vec2 hatGradient(const Vec2& opposite) { return {-opposite.y() / 2, opposite.x() / 2}; }

/// D_f = R_f S_f. D_f maps the reference normal to the deformed one, so S_f is a symmetric 2x2 block in the reference's
/// tangent frame.
struct FaceDeformation {
  Mat3 rotation;  ///< R_f, det = +1
  Mat2 stretch;   ///< S_f in (t1, t2)
};

/// The deformation from the reference frame to the deformed corners, by the closed-form polar decomposition of a 3x2
/// matrix.
FaceDeformation deformation(const FaceFrame& reference, const Vec3& a, const Vec3& b, const Vec3& c);

/// Interpolation of a face's symmetric factor S_f.
enum class Stretch {
  /// interpolates S_f (the paper); beyond the keys it eases before a lower limit and stays definite, but a blend may
  /// become indefinite
  Linear,
  Log,  ///< interpolates log S_f; cannot turn inside out; beyond the keys it eases towards limits (stretch_limits.h)
};

/// Logarithm of a symmetric positive definite matrix, and exponential of a symmetric matrix.
Mat2 logSymmetric(const Mat2& m);
Mat2 expSymmetric(const Mat2& m);

}  // namespace shapespline
