#include "core/sparse/separator.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <utility>

#include <Eigen/Eigenvalues>

namespace shapespline {

namespace {

// In units of the square root of all nodes, the side of a square subgraph. For longer separators, other directions are
// worth trying: the diagonals, and the other axes. The cubes of the largest separators dominate the work of a
// factorisation.
constexpr double longSeparator = 1.1, veryLongSeparator = 1.6;
// Cost of a subgraph of n nodes over n^1.5, in units of a separator's cube. Without this cost, lopsided cuts would look
// too cheap.
constexpr double dissectionCost = 5.0;

// The principal axes, longest first.
std::array<Vec3, 3> principalAxes(std::span<const Vec3> points) {
  Vec3 mean = Vec3::Zero();
  for (const Vec3& p : points) mean += p;
  mean /= static_cast<double>(points.size());
  Mat3 covariance = Mat3::Zero();
  for (const Vec3& p : points) covariance += (p - mean) * (p - mean).transpose();
  const Eigen::SelfAdjointEigenSolver<Mat3> solver(covariance);
  return {solver.eigenvectors().col(2), solver.eigenvectors().col(1), solver.eigenvectors().col(0)};
}

// Left below the band around the median along a direction, Right above it. Ties are broken by number.
std::vector<Side> medianBand(std::span<const Vec3> coordinates, const Vec3& direction, const Band& band) {
  const double size = static_cast<double>(coordinates.size());
  const double halfBand = std::min(band.share * size, band.depth * std::sqrt(size));
  const auto low = static_cast<std::ptrdiff_t>(0.5 * size - halfBand),
             high = static_cast<std::ptrdiff_t>(0.5 * size + halfBand) + 1;
  std::vector<double> projection;
  projection.reserve(coordinates.size());
  for (const Vec3& p : coordinates) projection.push_back(direction.dot(p));
  std::vector<double> sorted = projection;
  std::nth_element(sorted.begin(), sorted.begin() + low, sorted.end());
  std::nth_element(sorted.begin() + low + 1, sorted.begin() + high, sorted.end());
  const double from = sorted[low], to = sorted[high];
  // Number of nodes exactly at a limit that belong below it.
  const auto tiesBelow = [&](std::ptrdiff_t count, double limit) {
    return count - std::count_if(projection.begin(), projection.end(), [&](double x) { return x < limit; });
  };
  std::ptrdiff_t belowFrom = tiesBelow(low, from), belowTo = tiesBelow(high, to);
  std::vector<Side> side(projection.size(), Side::Right);
  for (std::size_t v = 0; v < projection.size(); ++v) {
    const double x = projection[v];
    if (x < to || (x == to && belowTo-- > 0)) side[v] = Side::Separator;
    if (x < from || (x == from && belowFrom-- > 0)) side[v] = Side::Left;
  }
  return side;
}

// Adds nodes to the band until no edge crosses it.
void widenBand(const Graph& graph, std::vector<Side>& side) {
  for (int v = 0; v < graph.size(); ++v) {
    if (side[v] != Side::Left) continue;
    for (int u : graph.neighbours(v)) {
      if (side[u] != Side::Right) continue;
      side[v] = Side::Separator;
      break;
    }
  }
}

using OnStep = std::function<void()>;

std::vector<Side> separatorAlong(const Graph& graph, std::span<const Vec3> coordinates, const Vec3& direction,
                                 const Band& band, const OnStep& onStep) {
  std::vector<Side> side = medianBand(coordinates, direction, band);
  if (onStep) onStep();
  widenBand(graph, side);
  shrinkSeparator(graph, side);
  return side;
}

// Approximate elimination cost for these sides: the cube of the separator, plus the nested dissection cost of each
// side.
struct Cut {
  std::vector<Side> side;
  double separator = 0, cost = 0;
};

Cut cutAlong(const Graph& graph, std::span<const Vec3> coordinates, const Vec3& direction, const Band& band,
             const OnStep& onStep = {}) {
  Cut cut{separatorAlong(graph, coordinates, direction, band, onStep)};
  const auto count = [&](Side s) { return static_cast<double>(std::count(cut.side.begin(), cut.side.end(), s)); };
  cut.separator = count(Side::Separator);
  cut.cost = std::pow(cut.separator, 3) +
             dissectionCost * (std::pow(count(Side::Left), 1.5) + std::pow(count(Side::Right), 1.5));
  return cut;
}

}  // namespace

std::vector<Side> findSeparator(const Graph& graph, std::span<const Vec3> coordinates, const OnStep& onStep,
                                const Band& band) {
  const auto [first, second, third] = principalAxes(coordinates);
  Cut best = cutAlong(graph, coordinates, first, band, onStep);
  if (onStep) onStep();
  const struct {
    Vec3 direction;
    double worthAbove;
  } others[] = {{first + second, longSeparator},
                {first - second, longSeparator},
                {second, veryLongSeparator},
                {third, veryLongSeparator}};
  for (const auto& [direction, worthAbove] : others) {
    if (best.separator <= worthAbove * std::sqrt(graph.size())) break;
    Cut cut = cutAlong(graph, coordinates, direction, band);
    if (cut.cost < best.cost) best = std::move(cut);
  }
  return std::move(best.side);
}

}  // namespace shapespline
