#include "core/mesh/principal_offsets.h"

#include <algorithm>
#include <cmath>

#include <Eigen/Eigenvalues>

namespace shapespline {

namespace {

using Row = Eigen::Map<Eigen::VectorXf>;
using Rows = std::vector<std::vector<float>>;

// Components below this share of the first are rounding noise.
constexpr double smallest = 1e-14;
// Number of columns converted to double precision at a time, which small components need next to large ones.
constexpr Eigen::Index blockSize = 1024;

Row row(std::vector<float>& values) { return {values.data(), static_cast<Eigen::Index>(values.size())}; }

Eigen::MatrixXd gramOf(Rows& rows) {
  const Eigen::Index count = static_cast<Eigen::Index>(rows.size()), size = row(rows[0]).size();
  Eigen::MatrixXd gram = Eigen::MatrixXd::Zero(count, count);
  Eigen::MatrixXd block;  // each row is a column of the block
  for (Eigen::Index start = 0; start < size; start += blockSize) {
    const Eigen::Index width = std::min(blockSize, size - start);
    block.resize(width, count);
    for (Eigen::Index i = 0; i < count; ++i) block.col(i) = row(rows[i]).segment(start, width).cast<double>();
    for (Eigen::Index i = 0; i < count; ++i)
      for (Eigen::Index j = 0; j <= i; ++j) gram(i, j) += block.col(i).dot(block.col(j));
  }
  return gram.selfadjointView<Eigen::Lower>();
}

double largestDistance(const Rows& rows) {
  float largest = 0;
  for (const auto& values : rows)
    for (std::size_t i = 0; i + 2 < values.size(); i += 3)
      largest =
          std::max(largest, values[i] * values[i] + values[i + 1] * values[i + 1] + values[i + 2] * values[i + 2]);
  return std::sqrt(static_cast<double>(largest));
}

}  // namespace

PrincipalOffsets principalOffsets(Rows& rows, double tolerance, int most) {
  PrincipalOffsets out;
  out.largest = largestDistance(rows);
  if (out.largest <= tolerance || rows.empty()) return out;
  const Eigen::Index count = static_cast<Eigen::Index>(rows.size()), size = row(rows[0]).size();
  const Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd> solver(gramOf(rows));  // eigenvalues ascend
  const double first = solver.eigenvalues()[count - 1];
  std::vector<Eigen::VectorXf> weights;
  for (Eigen::Index k = count - 1; k >= 0 && out.count < most && out.largest > tolerance; --k) {
    if (!(solver.eigenvalues()[k] > smallest * first)) break;
    const Eigen::VectorXd direction = solver.eigenvectors().col(k);
    // Computed from the remaining rows, so rounding of earlier components does not accumulate.
    Eigen::VectorXf offset = Eigen::VectorXf::Zero(size);
    for (Eigen::Index i = 0; i < count; ++i) offset += static_cast<float>(direction[i]) * row(rows[i]);
    const double scale = direction.cwiseAbs().maxCoeff();
    offset *= static_cast<float>(scale);
    weights.push_back((direction / scale).cast<float>());
    for (Eigen::Index i = 0; i < count; ++i) row(rows[i]) -= weights.back()[i] * offset;
    out.offsets.insert(out.offsets.end(), offset.data(), offset.data() + size);
    out.largest = largestDistance(rows);
    ++out.count;
  }
  out.weights.resize(count * out.count);
  for (Eigen::Index i = 0; i < count; ++i)
    for (int k = 0; k < out.count; ++k) out.weights[i * out.count + k] = weights[k][i];
  return out;
}

}  // namespace shapespline
