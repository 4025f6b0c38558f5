#include "core/hold/hold_passes.h"

namespace shapespline {

void pathPositions(const PathEnd& from, const PathEnd& to, const PathWeights& w, Positions& positions) {
  positions.resize(from.position.size());
  for (std::size_t v = 0; v < positions.size(); ++v) {
    const double rest0 = from.rest[v], rest1 = to.rest[v];
    const double step = w.step - rest0 * w.rest0[0] - rest1 * w.rest1[0];
    const double slope0 = w.slope0 - rest0 * w.rest0[1] - rest1 * w.rest1[1];
    const double slope1 = w.slope1 - rest0 * w.rest0[2] - rest1 * w.rest1[2];
    const float *a = &from.slope[3 * v], *b = &to.slope[3 * v];
    const double *p = from.position[v].data(), *q = to.position[v].data();
    double* out = positions[v].data();
    for (int k = 0; k < 3; ++k) out[k] = p[k] + step * (q[k] - p[k]) + slope0 * a[k] + slope1 * b[k];
  }
}

FitSums fitSums(const std::vector<double>& area, const Vec3& origin, const Positions& from, const Positions& to) {
  FitSums sums;
  for (std::size_t v = 0; v < from.size(); ++v) {
    const Vec3 a = area[v] * (from[v] - origin), b = to[v] - origin;
    sums.from += a;
    sums.to += area[v] * b;
    sums.covariance.noalias() += b * a.transpose();
  }
  sums.covariance -= sums.to * sums.from.transpose();
  sums.from += origin;
  sums.to += origin;
  return sums;
}

void blendWithBody(double share, const Mat3& turn, const Vec3& mean, const Positions& body, Positions& target) {
  for (std::size_t v = 0; v < target.size(); ++v) {
    const Vec3 moved = turn * body[v] + mean;
    target[v] = share * target[v] + (1 - share) * moved;
  }
}

void moveRigidly(const Mat3& turn, const Vec3& move, Positions& positions) {
  for (Vec3& p : positions) p = (turn * p + move).eval();
}

void addMeans(const std::vector<int>& handleOf, const std::vector<double>& share, const Positions& positions,
              std::vector<Vec3>& means) {
  for (std::size_t v = 0; v < positions.size(); ++v)
    if (handleOf[v] >= 0) means[handleOf[v]] += share[v] * positions[v];
}

void scatterWay(const Positions& from, const Positions& to, const std::vector<double>& weight, double share,
                const std::vector<int>& slot, std::vector<double>& xyzp) {
  for (std::size_t v = 0; v < from.size(); ++v)
    for (int k = 0; k < 3; ++k)
      xyzp[4 * static_cast<std::size_t>(slot[v]) + k] = share * weight[v] * (to[v][k] - from[v][k]);
}

void addGathered(const std::vector<double>& xyzp, const std::vector<int>& slot, Positions& positions) {
  for (std::size_t v = 0; v < positions.size(); ++v)
    for (int k = 0; k < 3; ++k) positions[v][k] += xyzp[4 * static_cast<std::size_t>(slot[v]) + k];
}

void readPlaces(const std::vector<float>& xyzp, const std::vector<int>& slot, const Vec3& move, Positions& positions) {
  positions.resize(slot.size());
  for (std::size_t v = 0; v < positions.size(); ++v)
    for (int k = 0; k < 3; ++k) positions[v][k] = xyzp[4 * static_cast<std::size_t>(slot[v]) + k] + move[k];
}

void writePlaces(const Positions& positions, const std::vector<int>& slot, const Vec3& move, std::vector<float>& xyzp) {
  for (std::size_t v = 0; v < positions.size(); ++v)
    for (int k = 0; k < 3; ++k)
      xyzp[4 * static_cast<std::size_t>(slot[v]) + k] = static_cast<float>(positions[v][k] - move[k]);
}

void toSingle(const std::vector<double>& from, std::vector<float>& to) {
  to.resize(from.size());
  for (std::size_t i = 0; i < from.size(); ++i) to[i] = static_cast<float>(from[i]);
}

void toDouble(const std::vector<float>& from, std::vector<double>& to) {
  to.resize(from.size());
  for (std::size_t i = 0; i < from.size(); ++i) to[i] = from[i];
}

}  // namespace shapespline
