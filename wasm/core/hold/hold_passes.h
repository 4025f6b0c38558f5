// What a held frame does with every vertex: plain loops over arrays.
#pragma once

#include <vector>

#include "core/base/types.h"

namespace shapespline {

/// How the positions of a span's ends, the slopes there and what rests make up those between (vertex_path.h): of the
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

/// Sums over all vertices, by their areas; the covariance about `origin`.
struct FitSums {
  Vec3 from = Vec3::Zero(), to = Vec3::Zero();
  Mat3 covariance = Mat3::Zero();
};
FitSums fitSums(const std::vector<double>& area, const Vec3& origin, const Positions& from, const Positions& to);

/// target <- share * target + (1 - share) * (turn * body + mean)
void blendWithBody(double share, const Mat3& turn, const Vec3& mean, const Positions& body, Positions& target);

/// p <- turn * p + move
void moveRigidly(const Mat3& turn, const Vec3& move, Positions& positions);

/// Adds share * position to the mean of each vertex's handle.
void addMeans(const std::vector<int>& handleOf, const std::vector<double>& share, const Positions& positions,
              std::vector<Vec3>& means);

/// share * weight * (to - from), as (x, y, z, pad) at `slot`.
void scatterWay(const Positions& from, const Positions& to, const std::vector<double>& weight, double share,
                const std::vector<int>& slot, std::vector<double>& xyzp);
/// Between such vectors and positions.
void addGathered(const std::vector<double>& xyzp, const std::vector<int>& slot, Positions& positions);
void readPlaces(const std::vector<float>& xyzp, const std::vector<int>& slot, const Vec3& move, Positions& positions);
void writePlaces(const Positions& positions, const std::vector<int>& slot, const Vec3& move, std::vector<float>& xyzp);

void toSingle(const std::vector<double>& from, std::vector<float>& to);
void toDouble(const std::vector<float>& from, std::vector<double>& to);

}  // namespace shapespline
