// What a user can choose about a sequence. Plain data; the defaults are the paper's.
#pragma once

#include <optional>
#include <vector>

#include "core/base/types.h"
#include "core/hold/held_motion.h"
#include "core/hold/pin.h"
#include "core/space/lri_space.h"
#include "core/space/own_paths_space.h"
#include "core/spline/rotation_spline.h"
#include "core/spline/spline.h"

namespace shapespline {

/// How the keys are joined. The first is the method; the others are the baselines it is compared with.
enum class Method {
  Lri,             ///< cubic splines in LRI space (the method)
  Geodesic,        ///< piecewise linear in LRI space (Kilian et al. 2007, as in Fig. 1)
  Linear,          ///< piecewise linear vertex positions: what morph targets do
  CubicVertex,     ///< cubic splines of the vertex positions
  RotationStrain,  ///< cubic splines of rotation-strain coordinates (Huang et al. 2011)
  Rimd,            ///< cubic splines of rotation-invariant mesh differences (Gao et al. 2016)
};

/// Whether every vertex moves on its own: the baselines.
constexpr bool blendsVertices(Method method) { return method == Method::Linear || method == Method::CubicVertex; }

/// Whether faces rotate by themselves, without patches that could be held or take turns: the rival spaces.
constexpr bool turnsFaces(Method method) { return method == Method::RotationStrain || method == Method::Rimd; }

/// Choices that refit the spline only: changing them never encodes again, and factors nothing but for `hold` and
/// `pins`.
struct MotionOptions {
  Method method = Method::Lri;
  BoundaryKind boundary = BoundaryKind::Natural;
  double startSpeed = 1;         ///< hermite: times the one-sided difference at the first key; 0 = ease
  double endSpeed = 1;           ///< hermite: the same at the last key
  std::optional<double> period;  ///< periodic: whole period in units of time; default: defaultPeriod() in spline.h
  std::vector<double> tension;   ///< empty, or J values: slope at a key = (1 - tension) * the C2 spline's own
  /// Kochanek-Bartels bias: empty, or J values in [-1, 1]. From 0 to 1 the slope at a key goes over to the difference
  /// from the key before, from 0 to -1 to that to the key after (at an end key to the only one).
  std::vector<double> bias;
  std::vector<AddedTurns> turns;
  bool hold = false;      ///< what rests between keys stays (hold/); with Method::Lri and three keys or more
  std::vector<Pin> pins;  ///< with Method::Lri
  OwnPaths ownPaths = OwnPaths::Off;  ///< with Method::Lri, without added turns
  bool inPlace = false;               ///< take out the translation that accumulates along the sequence
};

/// Choices that change the encoding: a new sequence is built for them.
struct EncodingOptions : LriOptions {
  int reference = 0;  ///< 0-based key that deformation gradients are measured from
  /// hermite: shapes that take the place of key 2 in the difference at key 1, and of key J - 1 in that at key J
  std::optional<Positions> startTangent, endTangent;
};

}  // namespace shapespline
