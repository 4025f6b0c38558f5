// Rotations that move through the keys: the cumulative form on SO(3) (Kim, Kim and Shin 1995). A body may turn far and
// often, which a splined rotation vector cannot say.
#pragma once

#include <vector>

#include "core/rotation/rotation.h"
#include "core/spline/spline.h"

namespace shapespline {

/// Whole turns that one path takes in a step, on top of its increment: axis times angle, a multiple of 2 pi.
struct WholeTurns {
  int step;
  std::size_t path;
  Vec3 vector;
};

/// R(t) = R_b prod_s exp(C_s(t) w_s): R_b the rotation at the curve's base key, w_s with exp(w_s) = R_from^T R_to the increment of step s
/// and C_s its share (spline.h). Exact at the keys, as smooth as the weights, any number of turns, and for two keys the geodesic.
struct RotationPaths {
  std::vector<std::vector<Quaternion>> key;     ///< key[column][path], unit
  std::vector<std::vector<Vec3>> increment;     ///< increment[step][path], radians; empty for steps that there are not

  std::vector<WholeTurns> turns;

  /// Every path at `point`. rotation: resized, unit.
  void at(const CurvePoint& point, std::vector<Quaternion>& rotation) const;
};

}  // namespace shapespline
