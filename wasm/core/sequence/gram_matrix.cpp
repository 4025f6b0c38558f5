#include "core/sequence/gram_matrix.h"

#include <algorithm>
#include <cmath>

#include <Eigen/Eigenvalues>

#include "core/lri/face_frame.h"
#include "core/rotation/rotation.h"

namespace shapespline {

template <class Real>
Eigen::MatrixXd gramMatrix(const PatchCoordinates& k, const LriCoordinates<Real>& x, const WeldedShape& shape,
                           double diagonal) {
  const int columns = shape.columns();
  Eigen::MatrixXd gram = Eigen::MatrixXd::Zero(columns, columns);
  Eigen::MatrixXd entry(columns, numbersPerFace);
  double totalArea = 0;
  for (double a : k.graph.area()) totalArea += a;
  const Positions& reference = shape.poses[shape.reference];
  for (int f = 0; f < shape.faceCount(); ++f) {
    if (k.patches.ofFace[f] < 0) continue;
    const Triangle& t = shape.faces[f];
    const double area = faceFrame(reference[t[0]], reference[t[1]], reference[t[2]]).area;
    for (int c = 0; c < columns; ++c)
      for (int k = 0; k < numbersPerFace; ++k) entry(c, k) = static_cast<double>(x.face.at(f, c, k));
    entry.col(4) *= std::sqrt(2.0);  // xy stands twice in |S|_F^2
    gram.noalias() += (area / totalArea) * entry * entry.transpose();
  }
  double shared = 0;
  for (const PatchPair& p : k.patches.pairs) shared += p.sharedEdges;
  for (std::size_t p = 0; p < k.patches.pairs.size(); ++p)
    for (int a = 0; a < columns; ++a)
      for (int b = 0; b < columns; ++b)
        gram(a, b) += k.patches.pairs[p].sharedEdges / shared * k.pair[a][p].dot(k.pair[b][p]);
  for (int a = 0; a < columns; ++a)
    for (int b = 0; b < columns; ++b)
      gram(a, b) +=
          (x.meanPosition[a] - x.meanPosition[0]).dot(x.meanPosition[b] - x.meanPosition[0]) / (diagonal * diagonal);
  return gram;
}

template Eigen::MatrixXd gramMatrix(const PatchCoordinates&, const LriCoordinates<float>&, const WeldedShape&, double);
template Eigen::MatrixXd gramMatrix(const PatchCoordinates&, const LriCoordinates<double>&, const WeldedShape&, double);

PrincipalPlane::PrincipalPlane(const Eigen::MatrixXd& gram, int keys) : gram_(gram) {
  const auto columns = gram.cols();
  mean_ = Eigen::VectorXd::Zero(columns);
  mean_.head(keys).setConstant(1.0 / keys);
  const Eigen::MatrixXd centre = Eigen::MatrixXd::Identity(columns, columns).leftCols(keys).colwise() - mean_;
  const Eigen::MatrixXd centred = centre.transpose() * gram * centre;
  const Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd> solver(centred);
  direction_ = Eigen::MatrixXd::Zero(columns, 2);
  double total = 0;
  for (int j = 0; j < keys; ++j) total += std::max(0.0, solver.eigenvalues()[j]);
  for (int axis = 0; axis < 2 && axis < keys; ++axis) {
    const double value = solver.eigenvalues()[keys - 1 - axis];
    if (!(value > 1e-14 * total)) continue;
    Eigen::VectorXd vector = solver.eigenvectors().col(keys - 1 - axis);
    if (vector[keys - 1] < vector[0]) vector = -vector;  // a fixed sign: the last key lies on the greater side
    direction_.col(axis) = centre * vector / std::sqrt(value);
    explained_ += value / total;
  }
}

Vec2 PrincipalPlane::project(const Eigen::VectorXd& weights) const {
  return direction_.transpose() * (gram_ * (weights - mean_));
}

}  // namespace shapespline
