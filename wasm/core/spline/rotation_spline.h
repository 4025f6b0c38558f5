// Rotations that move through the keys: the cumulative form on SO(3) (Kim, Kim and Shin 1995). A body may turn far and
// often, which a splined rotation vector cannot say.
#pragma once

#include <span>
#include <vector>

#include "core/rotation/rotation.h"
#include "core/spline/spline.h"

namespace shapespline {

/// Whole turns added on the way to a key, to the whole shape or to one component against the one that carries it.
struct AddedTurns {
  int key = 1;         ///< 0-based, at least 1: the turns happen between key - 1 and key
  int turns = 0;       ///< whole turns about the axis of that increment; negative turns go the other way
  int component = -1;  ///< 0-based, components counted by their first face in the file; -1: the whole shape
};

/// Whole turns that one path takes in a step, on top of its increment: axis times angle, a multiple of 2 pi.
struct WholeTurns {
  int step;
  std::size_t path;
  Vec3 vector;
};

/// Rotations through the keys: F(t) = R_b prod_s exp(C_s w_s), R_b the rotation at the curve's base key, w_s with
/// exp(w_s) = R_from^T R_to the increment of step s and C_s its share (spline.h). Exact at the keys, as smooth as the
/// weights, any number of turns, and for two keys the geodesic.
///
/// Increments do not commute: F of the reversed keys is another motion, B(t). The path is the normalised sum of the two
/// quaternions, so reversed keys give the reversed motion.
class RotationSplines {
 public:
  std::vector<std::vector<Quaternion>> key;  ///< key[column][path], unit
  std::vector<std::vector<Vec3>> increment;  ///< increment[step][path], radians; empty for steps that there are not

  /// To be called when all increments are known, before at().
  void finish(KeySteps steps);

  /// Every path at `point`, with whole turns added. rotation: resized, unit.
  void at(const CurvePoint& point, std::span<const WholeTurns> turns, std::vector<Quaternion>& rotation) const;

 private:
  std::vector<std::vector<Quaternion>> stepRotation_;  // exp of the increments, with their sign; none for end tangents
};

}  // namespace shapespline
