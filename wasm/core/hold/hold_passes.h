// What a held frame does with every vertex: plain loops over arrays.
#pragma once

#include <vector>

#include "core/base/types.h"

namespace shapespline {

/// How the positions of a span's ends, the slopes there and what rests make up those between (resting_spline.h): of the
/// step and the slopes at both ends, and of the parts of them that rest takes away at either end.
struct PathWeights {
  double step = 0, slope0 = 0, slope1 = 0, rest0[3] = {}, rest1[3] = {};
};

/// What a path has at one end of a span: positions, slopes (xyz), rest.
struct PathEnd {
  const Positions& position;
  const std::vector<float>&slope, &rest;
};

void pathPositions(const PathEnd& from, const PathEnd& to, const PathWeights& weights, Positions& positions);

/// Means over some vertices, by their areas; the covariances about these: of one with the other, of each with itself.
struct FitSums {
  Vec3 from = Vec3::Zero(), to = Vec3::Zero();
  Mat3 covariance = Mat3::Zero(), ofFrom = Mat3::Zero(), ofTo = Mat3::Zero();
};
/// origin: near them, so little is lost.
FitSums fitSums(const std::vector<double>& area, const Vec3& origin, const std::vector<int>& vertices,
                const Positions& from, const Positions& to);

/// What pulls a vertex, as seen from a patch.
struct PatchPull {
  int vertex, patch;
  float at[3];
};
/// Adds to each vertex what pulls it, by the matrix of the patch.
void addPulls(const std::vector<PatchPull>& pulls, const std::vector<Mat3>& patch, Positions& sum);

/// Sum of to[i] * from[i]^T over `count` vectors.
Mat3 outerProducts(std::size_t count, const Vec3* to, const Vec3* from);

/// Sum of weight[i] * vector[i] over `count` vectors.
Vec3 weightedSum(std::size_t count, const double* weight, const Vec3* vector);

/// target <- share * target + (1 - share) * (turn * body + mean); body: of `vertices` of the target.
void blendWithBody(double share, const Mat3& turn, const Vec3& mean, const Positions& body,
                   const std::vector<int>& vertices, Positions& target);

/// p <- turn * p + move
void moveRigidly(const Mat3& turn, const Vec3& move, const std::vector<int>& vertices, Positions& positions);
void moveBy(const Vec3& move, Positions& positions);

/// share * weight * (to - from)
void pullsTo(const Positions& from, const Positions& to, const std::vector<double>& weight, double share,
             Positions& pull);

/// How pulls at all vertices move some handles: `handles` numbers for each vertex. Takes what the handles are moved by
/// away from `left`.
void takeResponse(const std::vector<float>& response, const Positions& pull, std::vector<Vec3>& left);

/// Between positions and (x, y, z, pad) at `slot`.
void readXyzp(const std::vector<float>& xyzp, const std::vector<int>& slot, const Vec3& move, Positions& positions);
template <class Real>
void addXyzp(const std::vector<Real>& xyzp, const std::vector<int>& slot, Positions& positions);
template <class Real>
void writeXyzp(const Positions& positions, const std::vector<int>& slot, const Vec3& move, std::vector<Real>& xyzp);

}  // namespace shapespline
