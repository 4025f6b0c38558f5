// The per-vertex work of a held frame, as plain loops over arrays.
#pragma once

#include <vector>

#include "core/base/types.h"

namespace shapespline {

/// Weights for positions inside a span (resting_spline.h): weights of the step between its ends, of the slopes at both
/// ends, and of the parts that rest removes at either end.
struct PathWeights {
  double step = 0, slope0 = 0, slope1 = 0, rest0[3] = {}, rest1[3] = {};
};

/// Data of a path at one end of a span: positions, slopes (xyz), rest.
struct PathEnd {
  const Positions& position;
  const std::vector<float>&slope, &rest;
};

void pathPositions(const PathEnd& from, const PathEnd& to, const PathWeights& weights, Positions& positions);

/// Area-weighted means over some vertices, and the covariances about these means: mixed, of `from`, of `to`.
struct FitSums {
  Vec3 from = Vec3::Zero(), to = Vec3::Zero();
  Mat3 covariance = Mat3::Zero(), ofFrom = Mat3::Zero(), ofTo = Mat3::Zero();
};
/// origin: close to the vertices, to limit rounding errors.
FitSums fitSums(const std::vector<double>& area, const Vec3& origin, const std::vector<int>& vertices,
                const Positions& from, const Positions& to);

/// The pull on a vertex, in the frame of a patch.
struct PatchPull {
  int vertex, patch;
  float at[3];
};
/// Adds the pull on each vertex, transformed by the matrix of its patch.
void addPulls(const std::vector<PatchPull>& pulls, const std::vector<Mat3>& patch, Positions& sum);

/// Sum of to[i] * from[i]^T over `count` vectors.
Mat3 outerProducts(std::size_t count, const Vec3* to, const Vec3* from);

/// Sum of weight[i] * vector[i] over `count` vectors.
Vec3 weightedSum(std::size_t count, const double* weight, const Vec3* vector);

/// target <- share * target + (1 - share) * (turn * group + mean). group: positions of `vertices`.
void blendWithGroup(double share, const Mat3& turn, const Vec3& mean, const Positions& group,
                    const std::vector<int>& vertices, Positions& target);

/// p <- turn * p + move
void moveRigidly(const Mat3& turn, const Vec3& move, const std::vector<int>& vertices, Positions& positions);
void moveBy(const Vec3& move, Positions& positions);

/// share * weight * (to - from)
void pullsTo(const Positions& from, const Positions& to, const std::vector<double>& weight, double share,
             Positions& pull);

/// Subtracts from `left` the handles' displacements by all pulls. response: `handles` numbers per vertex.
void takeResponse(const std::vector<float>& response, const Positions& pull, std::vector<Vec3>& left);

/// Converts between positions and (x, y, z, pad) at `slot`.
void readXyzp(const std::vector<float>& xyzp, const std::vector<int>& slot, const Vec3& move, Positions& positions);
template <class Real>
void addXyzp(const std::vector<Real>& xyzp, const std::vector<int>& slot, Positions& positions);
template <class Real>
void writeXyzp(const Positions& positions, const std::vector<int>& slot, const Vec3& move, std::vector<Real>& xyzp);

}  // namespace shapespline
