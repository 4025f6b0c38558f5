#include "core/lri/face_frame.h"

#include <algorithm>
#include <cmath>

namespace shapespline {

namespace {

// Applies f to the eigenvalues of a symmetric 2x2 matrix, by Sylvester's formula.
template <class F>
Mat2 mapEigenvalues(const Mat2& m, F f) {
  const double mean = (m(0, 0) + m(1, 1)) / 2;
  const double half = std::hypot((m(0, 0) - m(1, 1)) / 2, m(0, 1));
  const double high = mean + half, low = mean - half;
  const double fHigh = f(high), fLow = f(low);
  // The divided difference tends to f'(mean); for equal eigenvalues the second term vanishes with (m - mean I).
  if (half <= 1e-15 * std::abs(mean)) return fHigh * Mat2::Identity();
  const double slope = (fHigh - fLow) / (2 * half);
  return ((fHigh + fLow) / 2) * Mat2::Identity() + slope * (m - mean * Mat2::Identity());
}

}  // namespace

FaceFrame faceFrame(const Vec3& a, const Vec3& b, const Vec3& c) {
  const Vec3 e1 = b - a, e2 = c - a;
  const Vec3 cross = e1.cross(e2);
  const Vec3 n = cross.normalized();
  const Vec3 t1 = e1.normalized();
  const Vec3 t2 = n.cross(t1);
  FaceFrame frame;
  frame.basis << t1, t2, n;
  frame.edges << e1.dot(t1), e2.dot(t1), 0, e2.dot(t2);
  frame.area = cross.norm() / 2;
  return frame;
}

FaceDeformation deformation(const FaceFrame& reference, const Vec3& a, const Vec3& b, const Vec3& c) {
  Eigen::Matrix<double, 3, 2> deformed;
  deformed << b - a, c - a;
  const Mat2& e = reference.edges;  // upper triangular
  Mat2 inverse;
  inverse << 1 / e(0, 0), -e(0, 1) / (e(0, 0) * e(1, 1)), 0, 1 / e(1, 1);
  const Eigen::Matrix<double, 3, 2> gradient = deformed * inverse;
  // S = sqrt(F^T F) = (C + sqrt(det C) I) / sqrt(tr C + 2 sqrt(det C)); det C from the cross product keeps its digits.
  const Mat2 c2 = gradient.transpose() * gradient;
  const Vec3 cross = gradient.col(0).cross(gradient.col(1));
  const double root = cross.norm();
  FaceDeformation result;
  result.stretch = (c2 + root * Mat2::Identity()) / std::sqrt(c2.trace() + 2 * root);
  // F S^-1, with the inverse of a symmetric 2x2 matrix whose determinant is `root`.
  Mat2 adjugate;
  adjugate << result.stretch(1, 1), -result.stretch(0, 1), -result.stretch(0, 1), result.stretch(0, 0);
  const Eigen::Matrix<double, 3, 2> tangents = gradient * adjugate / root;
  Mat3 frame;
  frame << tangents, cross / root;
  result.rotation = frame * reference.basis.transpose();
  return result;
}

Mat2 logSymmetric(const Mat2& m) {
  return mapEigenvalues(m, [](double x) { return std::log(std::max(x, 1e-300)); });
}

Mat2 expSymmetric(const Mat2& m) {
  return mapEigenvalues(m, [](double x) { return std::exp(x); });
}

}  // namespace shapespline
