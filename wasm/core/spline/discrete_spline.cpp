#include "core/spline/discrete_spline.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "core/base/format.h"

namespace shapespline {

namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::RowVectorXd;

// An affine map of a path: rows of weights, plus a constant.
struct Affine {
  MatrixXd samples, columns;
};

struct Grid {
  double start, step;
  Index samples;
  bool periodic;
  RowVectorXd period;  // periodic: increment of a path per period

  // Adds `factor` times sample i to a row. A periodic path continues beyond its ends.
  void add(Affine& to, Index row, Index i, double factor) const {
    const Index periods = periodic ? (i >= samples) - (i < 0) : 0;
    to.samples(row, i - periods * samples) += factor;
    to.columns.row(row) += factor * static_cast<double>(periods) * period;
  }
};

Affine nothing(Index rows, Index samples, Index columns) {
  return {MatrixXd::Zero(rows, samples), MatrixXd::Zero(rows, columns)};
}

Affine secondDifferences(const Grid& grid, Index columns) {
  const Index first = grid.periodic ? 0 : 1, rows = grid.samples - 2 * first;
  Affine bend = nothing(rows, grid.samples, columns);
  for (Index row = 0; row < rows; ++row)
    for (const int k : {-1, 0, 1}) grid.add(bend, row, first + row + k, k == 0 ? -2 : 1);
  return bend;
}

// Differences at the ends, with an outer neighbour given by the assigned slope m: 2 (x_1 - x_0 - h m). They count half.
Affine endDifferences(const Grid& grid, const RowVectorXd& startSlope, const RowVectorXd& endSlope) {
  Affine bend = nothing(2, grid.samples, startSlope.size());
  const Index last = grid.samples - 1;
  bend.samples(0, 1) = 2;
  bend.samples(0, 0) = -2;
  bend.samples(1, last - 1) = 2;
  bend.samples(1, last) = -2;
  bend.columns.row(0) = -2 * grid.step * startSlope;
  bend.columns.row(1) = 2 * grid.step * endSlope;
  bend.samples *= std::sqrt(0.5);
  bend.columns *= std::sqrt(0.5);
  return bend;
}

Affine stacked(const Affine& a, const Affine& b) {
  Affine both = nothing(a.samples.rows() + b.samples.rows(), a.samples.cols(), a.columns.cols());
  both.samples << a.samples, b.samples;
  both.columns << a.columns, b.columns;
  return both;
}

// Evaluates the path at the keys.
Affine atKeys(const Grid& grid, const std::vector<double>& keyTimes, Index columns) {
  Affine keys = nothing(static_cast<Index>(keyTimes.size()), grid.samples, columns);
  for (std::size_t j = 0; j < keyTimes.size(); ++j) {
    const double sample = (keyTimes[j] - grid.start) / grid.step;
    const Index before =
        std::clamp<Index>(static_cast<Index>(std::floor(sample)), 0, grid.samples - (grid.periodic ? 1 : 2));
    const double share = sample - static_cast<double>(before);
    grid.add(keys, static_cast<Index>(j), before, 1 - share);
    grid.add(keys, static_cast<Index>(j), before + 1, share);
  }
  return keys;
}

// Solves a x = b for all columns of b, in place: Gaussian elimination with partial pivoting. (Eigen's code is ten times
// as long, and K is small.)
void eliminate(MatrixXd& a, MatrixXd& b) {
  const Index n = a.rows();
  // column -= factor * (part of `by` below row k)
  const auto reduce = [n](double* column, const double* by, double factor, Index k) {
    for (Index i = k + 1; i < n; ++i) column[i] -= factor * by[i];
  };
  for (Index k = 0; k < n; ++k) {
    Index pivot = k;
    for (Index i = k + 1; i < n; ++i)
      if (std::abs(a(i, k)) > std::abs(a(pivot, k))) pivot = i;
    for (Index j = k; j < n; ++j) std::swap(a(k, j), a(pivot, j));
    for (Index j = 0; j < b.cols(); ++j) std::swap(b(k, j), b(pivot, j));
    for (Index i = k + 1; i < n; ++i) a(i, k) /= a(k, k);
    for (Index j = k + 1; j < n; ++j)
      if (a(k, j) != 0) reduce(&a(0, j), &a(0, k), a(k, j), k);
    for (Index j = 0; j < b.cols(); ++j) reduce(&b(0, j), &a(0, k), b(k, j), k);
  }
  for (Index j = 0; j < b.cols(); ++j)
    for (Index k = n - 1; k >= 0; --k) {
      b(k, j) /= a(k, k);
      for (Index i = 0; i < k; ++i) b(i, j) -= a(i, k) * b(k, j);
    }
}

}  // namespace

MatrixXd product(const MatrixXd& a, const MatrixXd& b) {
  MatrixXd result = MatrixXd::Zero(a.rows(), b.cols());
  for (Index j = 0; j < b.cols(); ++j)
    for (Index k = 0; k < a.cols(); ++k)
      if (const double factor = b(k, j); factor != 0)
        for (Index i = 0; i < a.rows(); ++i) result(i, j) += a(i, k) * factor;
  return result;
}

Result<DiscreteSpline> DiscreteSpline::fit(const std::vector<double>& keyTimes, BoundaryKind boundary,
                                           const Curve& curve, int samples) {
  std::vector<double> held = keyTimes;
  // The key that closes a period repeats the first key.
  if (curve.periodic() && held.size() > 1 && held.back() >= curve.end()) held.pop_back();
  const double span = curve.end() - curve.start();
  double shortest = span;
  for (std::size_t j = 1; j < keyTimes.size(); ++j) shortest = std::min(shortest, keyTimes[j] - keyTimes[j - 1]);
  const int least = std::max(4, static_cast<int>(std::min(std::ceil(span / shortest * (1 - 1e-9)), 1e9)) + 1);
  if (samples < least || samples > maxSamples)
    return Error{ErrorCode::InvalidOption, "The path has " + grouped(samples) + " samples. Use " + grouped(least) +
                                               " to " + grouped(maxSamples) +
                                               ", at least one for every interval between keys."};

  const Index columns = curve.weights(curve.start()).size();
  const Grid grid{curve.start(), span / (curve.periodic() ? samples : samples - 1), samples, curve.periodic(),
                  (curve.weights(curve.end()) - curve.weights(curve.start())).transpose()};
  Affine bend = secondDifferences(grid, columns);
  if (boundary == BoundaryKind::Hermite)
    bend = stacked(bend, endDifferences(grid, curve.weights(curve.start(), 1).transpose(),
                                        curve.weights(curve.end(), 1).transpose()));
  const Affine keys = atKeys(grid, held, columns);
  const Index count = keys.samples.rows();

  // Minimises |D x + b|^2 with C x = y: the gradient D^T (D x + b) is a combination of the keys' rows.
  MatrixXd matrix = MatrixXd::Zero(samples + count, samples + count), rhs(samples + count, columns);
  const MatrixXd adjoint = bend.samples.transpose();
  matrix.topLeftCorner(samples, samples) = product(adjoint, bend.samples);
  matrix.topRightCorner(samples, count) = keys.samples.transpose();
  matrix.bottomLeftCorner(count, samples) = keys.samples;
  rhs.topRows(samples) = -product(adjoint, bend.columns);
  rhs.bottomRows(count) = MatrixXd::Identity(count, columns) - keys.columns;

  DiscreteSpline spline;
  eliminate(matrix, rhs);
  spline.weights_ = rhs.topRows(samples);
  const double scale = std::pow(grid.step, -1.5);
  spline.differences_ = scale * bend.samples;
  spline.assigned_ = scale * bend.columns;
  spline.holds_ = keys.samples;
  for (Index i = 0; i < grid.samples; ++i) spline.times_.push_back(grid.start + static_cast<double>(i) * grid.step);
  if (!grid.periodic) spline.times_.back() = curve.end();
  return spline;
}

double DiscreteSpline::energy(const MatrixXd& path, const MatrixXd& gram) const {
  const MatrixXd bent = bend(path);
  return product(bent, gram).cwiseProduct(bent).sum();
}

MatrixXd DiscreteSpline::gradient(const MatrixXd& path) const { return product(differences_.transpose(), bend(path)); }

}  // namespace shapespline
