#include "core/sequence/gram_matrix.h"

#include <algorithm>
#include <cmath>

#include <Eigen/Eigenvalues>

#include "core/lri/face_frame.h"
#include "core/rotation/rotation.h"

namespace shapespline {

namespace {

Vec3 centroidOf(const Positions& p) {
  Vec3 sum = Vec3::Zero();
  for (const Vec3& x : p) sum += x;
  return sum / static_cast<double>(p.size());
}

Positions averageShape(const std::vector<Positions>& sequence) {
  Positions average(sequence.front().size(), Vec3::Zero());
  for (const Positions& frame : sequence)
    for (std::size_t v = 0; v < average.size(); ++v) average[v] += frame[v];
  for (Vec3& p : average) p /= static_cast<double>(sequence.size());
  return average;
}

}  // namespace

double enclosedVolume(const Positions& p, const std::vector<Triangle>& faces) {
  const Vec3 origin = p.empty() ? Vec3(Vec3::Zero()) : p.front();  // near the shape, so that far ones keep their digits
  double sum = 0;
  for (const Triangle& f : faces) sum += (p[f[0]] - origin).dot((p[f[1]] - origin).cross(p[f[2]] - origin));
  return sum / 6;
}

double surfaceArea(const Positions& p, const std::vector<Triangle>& faces) {
  double sum = 0;
  for (const Triangle& f : faces) sum += (p[f[1]] - p[f[0]]).cross(p[f[2]] - p[f[0]]).norm();
  return sum / 2;
}

double kgError(const std::vector<Positions>& sequence, const std::vector<Positions>& other, KgCentre centre) {
  const Positions average = centre == KgCentre::SequenceAverage ? averageShape(sequence) : Positions();
  double difference = 0, spread = 0;
  for (std::size_t k = 0; k < sequence.size(); ++k) {
    const Vec3 middle = centroidOf(sequence[k]);
    for (std::size_t v = 0; v < sequence[k].size(); ++v) {
      difference += (sequence[k][v] - other[k][v]).squaredNorm();
      spread += (sequence[k][v] - (average.empty() ? middle : average[v])).squaredNorm();
    }
  }
  return spread > 0 ? 100 * std::sqrt(difference / spread) : (difference > 0 ? INFINITY : 0);
}

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
      gram(a, b) += (x.meanPosition[a] - x.meanPosition[0]).dot(x.meanPosition[b] - x.meanPosition[0]) / (diagonal * diagonal);
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

RigidFit fitRigid(const Positions& from, const Positions& to) {
  const Vec3 a = centroidOf(from), b = centroidOf(to);
  Mat3 covariance = Mat3::Zero();
  for (std::size_t v = 0; v < from.size(); ++v) covariance += (to[v] - b) * (from[v] - a).transpose();
  RigidFit fit{projectToRotation(covariance), 0};
  for (std::size_t v = 0; v < from.size(); ++v)
    fit.largestDistance = std::max(fit.largestDistance, (fit.rotation * (from[v] - a) - (to[v] - b)).norm());
  return fit;
}

}  // namespace shapespline
