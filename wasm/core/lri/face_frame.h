// One triangle's deformation against the reference pose: R_f and S_f of the deformation gradient (paper section 4.2).
#pragma once

#include "core/rotation/rotation.h"
#include "core/base/types.h"

namespace shapespline {

/// A triangle of the reference pose in its own tangent frame: t1 along the first edge, t2 in the plane, n the normal.
struct FaceFrame {
  Mat3 basis;      ///< columns t1, t2, n: a rotation
  Mat2 edges;      ///< columns: second and third corner relative to the first, in (t1, t2)
  double area = 0;
};

/// Twice the area over the squared longest edge below which a triangle has no usable normal. float32 input places a
/// corner to about 1e-7 of the size, so that flatter triangles are noise.
inline constexpr double degenerateFlatness = 1e-6;

bool isDegenerate(const Vec3& a, const Vec3& b, const Vec3& c);

FaceFrame faceFrame(const Vec3& a, const Vec3& b, const Vec3& c);

/// D_f = R_f S_f. D_f maps the reference normal to the deformed one, so that S_f is a symmetric 2x2 block in the
/// reference's tangent frame.
struct FaceDeformation {
  Mat3 rotation;  ///< R_f, det = +1
  Mat2 stretch;   ///< S_f in (t1, t2)
};

/// Of the reference frame and the deformed corners, by the closed-form polar decomposition of a 3x2 matrix.
FaceDeformation deformation(const FaceFrame& reference, const Vec3& a, const Vec3& b, const Vec3& c);

/// Logarithm of a symmetric positive definite matrix and exponential of a symmetric one.
Mat2 logSymmetric(const Mat2& m);
Mat2 expSymmetric(const Mat2& m);

}  // namespace shapespline
