#include "core/hold/hold_passes.h"

#include "core/base/simd.h"

namespace shapespline {

namespace {

// Used instead of Eigen's products, which are not inlined in code compiled for size.
void addScaled(double scale, const double* vector, double* sum) {
  sum[0] += scale * vector[0];
  sum[1] += scale * vector[1];
  sum[2] += scale * vector[2];
}

}  // namespace

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

FitSums fitSums(const std::vector<double>& area, const Vec3& origin, const std::vector<int>& vertices,
                const Positions& from, const Positions& to) {
  FitSums sums;
  double whole = 0;
  for (const int v : vertices) {
    const double w = area[v];
    const Vec3 a = from[v] - origin, b = to[v] - origin;
    whole += w;
    addScaled(w, a.data(), sums.from.data());
    addScaled(w, b.data(), sums.to.data());
    for (int k = 0; k < 3; ++k) {
      addScaled(w * a[k], b.data(), sums.covariance.col(k).data());
      addScaled(w * a[k], a.data(), sums.ofFrom.col(k).data());
      addScaled(w * b[k], b.data(), sums.ofTo.col(k).data());
    }
  }
  sums.covariance -= sums.to * sums.from.transpose() / whole;
  sums.ofFrom -= sums.from * sums.from.transpose() / whole;
  sums.ofTo -= sums.to * sums.to.transpose() / whole;
  sums.from = sums.from / whole + origin;
  sums.to = sums.to / whole + origin;
  return sums;
}

void blendWithGroup(double share, const Mat3& turn, const Vec3& mean, const Positions& group,
                    const std::vector<int>& vertices, Positions& target) {
  for (std::size_t i = 0; i < vertices.size(); ++i) {
    const Vec3 moved = turn * group[i] + mean;
    target[vertices[i]] = share * target[vertices[i]] + (1 - share) * moved;
  }
}

void moveRigidly(const Mat3& turn, const Vec3& move, const std::vector<int>& vertices, Positions& positions) {
  for (const int v : vertices) {
    const Vec3 p = positions[v];
    double* moved = positions[v].data();
    for (int k = 0; k < 3; ++k) moved[k] = turn(k, 0) * p[0] + turn(k, 1) * p[1] + turn(k, 2) * p[2] + move[k];
  }
}

void moveBy(const Vec3& move, Positions& positions) {
  for (Vec3& p : positions) p += move;
}

void pullsTo(const Positions& from, const Positions& to, const std::vector<double>& weight, double share,
             Positions& pull) {
  pull.resize(from.size());
  for (std::size_t v = 0; v < from.size(); ++v) pull[v] = share * weight[v] * (to[v] - from[v]);
}

void addPulls(const std::vector<PatchPull>& pulls, const std::vector<Mat3>& patch, Positions& sum) {
  for (const PatchPull& p : pulls)
    for (int k = 0; k < 3; ++k) addScaled(p.at[k], patch[p.patch].data() + 3 * k, sum[p.vertex].data());
}

Mat3 outerProducts(std::size_t count, const Vec3* to, const Vec3* from) {
  Mat3 sum = Mat3::Zero();
  for (std::size_t i = 0; i < count; ++i)
    for (int k = 0; k < 3; ++k) addScaled(from[i][k], to[i].data(), sum.col(k).data());
  return sum;
}

Vec3 weightedSum(std::size_t count, const double* weight, const Vec3* vector) {
  Vec3 sum = Vec3::Zero();
  for (std::size_t i = 0; i < count; ++i) addScaled(weight[i], vector[i].data(), sum.data());
  return sum;
}

void takeResponse(const std::vector<float>& response, const Positions& pull, std::vector<Vec3>& left) {
  std::vector<Float4> sum(left.size(), Float4::zero());
  const float* row = response.data();
  for (const Vec3& p : pull) {
    const float at[4] = {static_cast<float>(p[0]), static_cast<float>(p[1]), static_cast<float>(p[2]), 0};
    for (Float4& h : sum) h = h + Float4::loadSplat(row++) * Float4::load(at);
  }
  for (std::size_t h = 0; h < left.size(); ++h) {
    float at[4];
    sum[h].store(at);
    left[h] -= Vec3(at[0], at[1], at[2]);
  }
}

void readXyzp(const std::vector<float>& xyzp, const std::vector<int>& slot, const Vec3& move, Positions& positions) {
  positions.resize(slot.size());
  for (std::size_t v = 0; v < positions.size(); ++v) {
    const float* at = &xyzp[4 * static_cast<std::size_t>(slot[v])];
    double* p = positions[v].data();
    p[0] = at[0] + move[0];
    p[1] = at[1] + move[1];
    p[2] = at[2] + move[2];
  }
}

template <class Real>
void addXyzp(const std::vector<Real>& xyzp, const std::vector<int>& slot, Positions& positions) {
  for (std::size_t v = 0; v < positions.size(); ++v) {
    const Real* at = &xyzp[4 * static_cast<std::size_t>(slot[v])];
    double* p = positions[v].data();
    p[0] += at[0];
    p[1] += at[1];
    p[2] += at[2];
  }
}

template <class Real>
void writeXyzp(const Positions& positions, const std::vector<int>& slot, const Vec3& move, std::vector<Real>& xyzp) {
  for (std::size_t v = 0; v < positions.size(); ++v) {
    Real* at = &xyzp[4 * static_cast<std::size_t>(slot[v])];
    const double* p = positions[v].data();
    at[0] = static_cast<Real>(p[0] - move[0]);
    at[1] = static_cast<Real>(p[1] - move[1]);
    at[2] = static_cast<Real>(p[2] - move[2]);
  }
}

template void addXyzp(const std::vector<float>&, const std::vector<int>&, Positions&);
template void addXyzp(const std::vector<double>&, const std::vector<int>&, Positions&);
template void writeXyzp(const Positions&, const std::vector<int>&, const Vec3&, std::vector<float>&);
template void writeXyzp(const Positions&, const std::vector<int>&, const Vec3&, std::vector<double>&);

}  // namespace shapespline
