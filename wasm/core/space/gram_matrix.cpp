#include "core/space/gram_matrix.h"

#include <algorithm>
#include <cmath>

#include <Eigen/Eigenvalues>

namespace shapespline {

// Uses plain loops, because Eigen's matrix product would add much code to the wasm module.
void addProducts(Eigen::MatrixXd& gram, double weight, const std::vector<double>& numbers) {
  const auto shapes = static_cast<std::size_t>(gram.rows()), count = numbers.size() / shapes;
  for (std::size_t a = 0; a < shapes; ++a)
    for (std::size_t b = 0; b < shapes; ++b) {
      double sum = 0;
      for (std::size_t k = 0; k < count; ++k) sum += numbers[a * count + k] * numbers[b * count + k];
      gram(static_cast<Eigen::Index>(a), static_cast<Eigen::Index>(b)) += weight * sum;
    }
}

namespace {

void putRow(std::vector<double>& numbers, int shape, const Vec3& v) {
  for (int k = 0; k < 3; ++k) numbers[3 * static_cast<std::size_t>(shape) + k] = v[k];
}

}  // namespace

Eigen::MatrixXd gramMatrix(const PoseCoordinates& poses, const WeldedShape& shape, double diagonal,
                           const ShapeCoordinates* other) {
  const PatchCoordinates& k = poses.patches;
  const int columns = shape.columns(), count = columns + (other ? 1 : 0);
  Eigen::MatrixXd gram = Eigen::MatrixXd::Zero(count, count);
  std::vector<double> entry(static_cast<std::size_t>(count) * numbersPerFace),
      three(static_cast<std::size_t>(count) * 3);
  double totalArea = 0;
  for (double a : k.graph.area()) totalArea += a;
  for (int f = 0; f < shape.faceCount(); ++f) {
    if (k.faceArea[f] == 0) continue;
    for (int c = 0; c < count; ++c)
      for (int n = 0; n < numbersPerFace; ++n) {
        const double value = c < columns ? poses.number(f, c, n) : other->face[f][n];
        // xy occurs twice
        entry[static_cast<std::size_t>(c) * numbersPerFace + n] = n == 4 ? std::sqrt(2.0) * value : value;
      }
    addProducts(gram, k.faceArea[f] / totalArea, entry);
  }
  double shared = 0;
  for (const PatchPair& p : k.patches.pairs) shared += p.sharedEdges;
  for (std::size_t p = 0; p < k.patches.pairs.size(); ++p) {
    for (int c = 0; c < count; ++c) putRow(three, c, c < columns ? k.pair[c][p] : other->pair[p]);
    addProducts(gram, k.patches.pairs[p].sharedEdges / shared, three);
  }
  for (int c = 0; c < count; ++c)
    putRow(three, c, (c < columns ? poses.meanPosition[c] : other->meanPosition) - poses.meanPosition[0]);
  addProducts(gram, 1 / (diagonal * diagonal), three);
  return gram;
}

Eigen::MatrixXd vertexGramMatrix(const WeldedShape& shape) {
  Eigen::MatrixXd gram = Eigen::MatrixXd::Zero(shape.columns(), shape.columns());
  std::vector<double> three(static_cast<std::size_t>(shape.columns()) * 3);
  for (int v = 0; v < shape.vertexCount(); ++v) {
    for (int c = 0; c < shape.columns(); ++c) putRow(three, c, shape.poses[c][v]);
    addProducts(gram, 1.0 / shape.vertexCount(), three);
  }
  return gram;
}

PrincipalPlane::PrincipalPlane(const Eigen::MatrixXd& gram, int keys) : gram_(gram) {
  const auto columns = gram.cols();
  mean_ = Eigen::VectorXd::Zero(columns);
  mean_.head(keys).setConstant(1.0 / keys);
  const Eigen::MatrixXd centre = Eigen::MatrixXd::Identity(columns, columns).leftCols(keys).colwise() - mean_;
  Eigen::MatrixXd centred(keys, keys);
  for (int j = 0; j < keys; ++j) centred.col(j).noalias() = centre.transpose() * (gram * centre.col(j));
  const Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd> solver(centred);
  direction_ = Eigen::MatrixXd::Zero(columns, 2);
  double total = 0;
  for (int j = 0; j < keys; ++j) total += std::max(0.0, solver.eigenvalues()[j]);
  for (int axis = 0; axis < 2 && axis < keys; ++axis) {
    const double value = solver.eigenvalues()[keys - 1 - axis];
    if (!(value > 1e-14 * total)) continue;
    Eigen::VectorXd vector = solver.eigenvectors().col(keys - 1 - axis);
    if (vector[keys - 1] < vector[0]) vector = -vector;  // fixes the sign: the last key is on the positive side
    direction_.col(axis) = centre * vector / std::sqrt(value);
    explained_ += value / total;
  }
  if (direction_.col(1).isZero(0)) leanTowards(keys, 1e-14 * total);
}

void PrincipalPlane::leanTowards(Eigen::Index firstColumn, double minSquare) {
  for (Eigen::Index c = firstColumn; c < gram_.cols(); ++c) {
    Eigen::VectorXd off = Eigen::VectorXd::Unit(gram_.cols(), c) - mean_;
    off -= direction_.col(0) * direction_.col(0).dot(gram_ * off);
    const double square = off.dot(gram_ * off);
    if (!(square > minSquare)) continue;
    minSquare = square;
    direction_.col(1) = off / std::sqrt(square);
  }
}

ShapeProducts PrincipalPlane::productsOf(const Eigen::VectorXd& weights) const {
  const Eigen::VectorXd products = gram_ * weights;
  return {products, weights.dot(products)};
}

Vec2 PrincipalPlane::project(const ShapeProducts& shape) const {
  return direction_.transpose() * (shape.columns - gram_ * mean_);
}

double PrincipalPlane::distance(const ShapeProducts& shape) const {
  const double fromMean = shape.squared - 2 * mean_.dot(shape.columns) + mean_.dot(gram_ * mean_);
  return std::sqrt(std::max(0.0, fromMean - project(shape).squaredNorm()));
}

}  // namespace shapespline
