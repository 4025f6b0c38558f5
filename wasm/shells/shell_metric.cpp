#include "shells/shell_metric.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <numbers>
#include <utility>

#include "core/mesh/mesh.h"

namespace shapespline {

namespace {

constexpr double bendingShare = 1e-4;  // weight of an angle relative to a length, divided by the area of the shape
constexpr double maxSlenderness = 10;  // limit of an angle's weight; without it, slivers would dominate the system

// One side of an edge: its face, the face's third corner, and whether it runs from the lower to the higher vertex.
struct Side {
  int face, opposite;
  bool upwards;
};

std::map<std::pair<int, int>, std::vector<Side>> sidesOfEdges(const std::vector<Triangle>& faces) {
  std::map<std::pair<int, int>, std::vector<Side>> sides;
  for (std::size_t f = 0; f < faces.size(); ++f)
    for (int c = 0; c < 3; ++c) {
      const int a = faces[f][c], b = faces[f][(c + 1) % 3];
      if (a != b) sides[std::minmax(a, b)].push_back({static_cast<int>(f), faces[f][(c + 2) % 3], a < b});
    }
  return sides;
}

double areaOf(const Triangle& f, const Positions& p) { return (p[f[1]] - p[f[0]]).cross(p[f[2]] - p[f[0]]).norm() / 2; }

double nearestBranch(double angle, double to) {
  constexpr double turn = 2 * std::numbers::pi;
  return angle - turn * std::round((angle - to) / turn);
}

}  // namespace

ShellMetric::ShellMetric(const std::vector<Triangle>& faces, const std::vector<Positions>& poses)
    : vertices_(static_cast<int>(poses.front().size())) {
  std::vector<const Positions*> all;
  for (const Positions& pose : poses) all.push_back(&pose);
  const std::vector<char> hasArea = facesWithArea(faces, all);
  const Positions& rest = poses.front();
  double whole = 0;
  for (const Triangle& f : faces) whole += areaOf(f, rest);
  std::vector<double> lengthWeight, angleWeight;
  std::vector<ShellEdge> plain;
  std::vector<double> plainWeight;
  for (const auto& [ends, sides] : sidesOfEdges(faces)) {
    double area = 0;
    for (const Side& s : sides) area += areaOf(faces[s.face], rest) / 3;
    const double squared = (rest[ends.second] - rest[ends.first]).squaredNorm();
    if (!(area > 0) || !(squared > 0)) continue;
    const bool bends = sides.size() == 2 && sides[0].upwards != sides[1].upwards && hasArea[sides[0].face] &&
                       hasArea[sides[1].face] && sides[0].opposite != sides[1].opposite;
    if (bends) {
      const Side& left = sides[0].upwards ? sides[0] : sides[1];
      const Side& right = sides[0].upwards ? sides[1] : sides[0];
      edges_.push_back({ends.first, ends.second, left.opposite, right.opposite});
      lengthWeight.push_back(area / squared);
      angleWeight.push_back(bendingShare * whole * std::min(squared / area, maxSlenderness));
    } else {
      plain.push_back({ends.first, ends.second});
      plainWeight.push_back(area / squared);
    }
  }
  angles_ = static_cast<int>(edges_.size());
  edges_.insert(edges_.end(), plain.begin(), plain.end());
  weight_ = std::move(lengthWeight);
  weight_.insert(weight_.end(), plainWeight.begin(), plainWeight.end());
  weight_.insert(weight_.end(), angleWeight.begin(), angleWeight.end());
}

ShellMeasures ShellMetric::measuresOf(const Positions& p) const {
  ShellMeasures z(measureCount());
  for (int e = 0; e < edgeCount(); ++e) z[e] = (p[edges_[e].to] - p[edges_[e].from]).norm();
  for (int a = 0; a < angles_; ++a) {
    const auto& [i, j, k, l] = edges_[a];
    const Vec3 edge = p[j] - p[i];
    const Vec3 left = edge.cross(p[k] - p[i]), right = (p[l] - p[i]).cross(edge);
    z[edgeCount() + a] = std::atan2(left.cross(right).dot(edge) / z[a], left.dot(right));
  }
  return z;
}

std::vector<ShellMeasures> ShellMetric::measuresOfKeys(const std::vector<Positions>& keys) const {
  std::vector<ShellMeasures> measures;
  for (const Positions& key : keys) {
    measures.push_back(measuresOf(key));
    if (measures.size() == 1) continue;
    const ShellMeasures& before = measures[measures.size() - 2];
    for (int a = edgeCount(); a < measureCount(); ++a)
      measures.back()[a] = nearestBranch(measures.back()[a], before[a]);
  }
  return measures;
}

ShellMeasures ShellMetric::difference(const ShellMeasures& a, const ShellMeasures& b) const {
  ShellMeasures d(measureCount());
  for (int m = 0; m < measureCount(); ++m) d[m] = a[m] - b[m];
  for (int m = edgeCount(); m < measureCount(); ++m) d[m] = nearestBranch(d[m], 0);
  return d;
}

double ShellMetric::squaredNorm(const ShellMeasures& difference) const {
  double sum = 0;
  for (int m = 0; m < measureCount(); ++m) sum += weight_[m] * difference[m] * difference[m];
  return sum;
}

ShellMetric::Row ShellMetric::rowOf(int measure, const Positions& p) const {
  const auto& [i, j, k, l] = edges_[measure < edgeCount() ? measure : measure - edgeCount()];
  const Vec3 edge = p[j] - p[i];
  const double length = edge.norm();
  if (measure < edgeCount()) {
    const Vec3 direction = edge / length;
    return {{i, j}, {-direction, direction}, 2};
  }
  const Vec3 left = edge.cross(p[k] - p[i]), right = (p[l] - p[i]).cross(edge);
  const Vec3 atLeft = -left * (length / left.squaredNorm()), atRight = -right * (length / right.squaredNorm());
  const double alongLeft = (p[k] - p[i]).dot(edge) / edge.squaredNorm();
  const double alongRight = (p[l] - p[i]).dot(edge) / edge.squaredNorm();
  return {{i, j, k, l},
          {-(1 - alongLeft) * atLeft - (1 - alongRight) * atRight, -alongLeft * atLeft - alongRight * atRight, atLeft,
           atRight},
          4};
}

ShellMeasures ShellMetric::changeOf(const Positions& positions, const Positions& change) const {
  ShellMeasures result(measureCount(), 0);
  for (int m = 0; m < measureCount(); ++m) {
    const Row row = rowOf(m, positions);
    for (int a = 0; a < row.count; ++a) result[m] += row.gradient[a].dot(change[row.vertex[a]]);
  }
  return result;
}

}  // namespace shapespline
