// Rotation splines through the keys in cumulative form on SO(3) (Kim, Kim and Shin 1995). A body may rotate by more
// than a turn, which a splined rotation vector cannot represent.
#pragma once

#include <span>
#include <vector>

#include "core/rotation/rotation.h"
#include "core/spline/spline.h"

namespace shapespline {

/// Full turns added before a key, to the whole shape or to one component relative to its parent.
struct AddedTurns {
  int key = 1;         ///< 0-based, at least 1: the turns take place between key - 1 and key
  int turns = 0;       ///< number of full turns about the increment's axis; negative for the opposite direction
  int component = -1;  ///< 0-based, components are numbered by their first face in the file; -1: the whole shape
};

/// Full turns of one path in a step, in addition to its increment: axis times angle, a multiple of 2 pi.
struct WholeTurns {
  int step;
  std::size_t path;
  Vec3 vector;
};

/// Rotations through the keys: F(t) = R_b prod_s exp(C_s w_s). R_b is the rotation at the curve's base key, w_s with
/// exp(w_s) = R_from^T R_to is the increment of step s, and C_s its share (spline.h). Exact at the keys, as smooth as
/// the weights, for any number of full turns. With two keys, it is the geodesic.
///
/// Increments do not commute, so the reversed keys give a different motion B(t). The path is the normalised sum of both
/// quaternions, so reversed keys give the reversed motion.
class RotationSplines {
 public:
  std::vector<std::vector<Quaternion>> key;  ///< key[column][path], unit
  std::vector<std::vector<Vec3>> increment;  ///< increment[step][path], radians; empty for unused steps

  /// Call after setting all increments and before at().
  void finish(KeySteps steps);

  /// Rotation of every path at `point`, including full turns. rotation: resized, unit.
  void at(const CurvePoint& point, std::span<const WholeTurns> turns, std::vector<Quaternion>& rotation) const;
  Quaternion pathAt(const CurvePoint& point, std::span<const WholeTurns> turns, std::size_t path) const;

 private:
  std::vector<std::vector<Quaternion>> stepRotation_;  // signed exp of the increments; empty for end tangents
};

}  // namespace shapespline
