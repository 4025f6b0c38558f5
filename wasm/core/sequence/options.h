// User options for a sequence. Plain data. The defaults are the paper's.
#pragma once

#include <optional>
#include <vector>

#include "core/base/types.h"
#include "core/hold/held_motion.h"
#include "core/hold/pin.h"
#include "core/sequence/timing_region.h"
#include "core/space/lri_space.h"
#include "core/spline/rotation_spline.h"
#include "core/spline/spline.h"

namespace shapespline {

/// Interpolation of the keys: the method first, followed by the baselines.
enum class Method {
  Lri,             ///< cubic splines in LRI space (the paper's method)
  Geodesic,        ///< piecewise linear in LRI space (Kilian et al. 2007, as in Fig. 1)
  Linear,          ///< piecewise linear vertex positions, like morph targets
  CubicVertex,     ///< cubic splines of the vertex positions
  RotationStrain,  ///< cubic splines of rotation-strain coordinates (Huang et al. 2011)
  Rimd,            ///< cubic splines of rotation-invariant mesh differences (Gao et al. 2016)
};

/// Whether every vertex moves separately: the vertex baselines.
constexpr bool blendsVertices(Method method) { return method == Method::Linear || method == Method::CubicVertex; }

/// Whether faces rotate separately. These methods have no patches, so no holding and no added turns.
constexpr bool turnsFaces(Method method) { return method == Method::RotationStrain || method == Method::Rimd; }

/// Options that only refit the spline. Changing them never encodes again, and factors only for `hold` and `pins`.
struct MotionOptions {
  Method method = Method::Lri;
  BoundaryKind boundary = BoundaryKind::Natural;
  double startSpeed = 1;  ///< hermite: factor on the one-sided difference at the first key; 0 = ease
  double endSpeed = 1;    ///< hermite: the same factor at the last key
  /// periodic: length of the period in units of time; default: defaultPeriod() in spline.h
  std::optional<double> period;
  std::vector<double> tension;  ///< empty, or J values: slope at a key = (1 - tension) * slope of the C2 spline
  /// Kochanek-Bartels bias: empty, or J values in [-1, 1]. Towards 1, the slope at a key approaches the difference to
  /// the previous key; towards -1, the difference to the next key. An end key uses its only difference.
  std::vector<double> bias;
  KeyTiming timing;                   ///< the last values count in loops
  std::vector<TimingRegion> regions;  ///< with Method::Lri: parts of the shape with timings of their own
  std::vector<AddedTurns> turns;
  bool hold = false;      ///< keep resting parts in place (hold/); with Method::Lri and three or more keys
  std::vector<Pin> pins;  ///< with Method::Lri
  bool inPlace = false;   ///< remove the translation accumulated along the sequence
};

/// Options that change the encoding and require a new shape.
struct EncodingOptions : LriOptions {
  int reference = 0;  ///< 0-based key, the reference of deformation gradients
  /// hermite: shapes that replace key 2 in the difference at key 1, and key J - 1 in the difference at key J
  std::optional<Positions> startTangent, endTangent;
};

}  // namespace shapespline
