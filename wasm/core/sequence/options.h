// What a user can choose about a sequence. Plain data; the defaults are the paper's.
#pragma once

#include <optional>
#include <vector>

#include "core/sparse/precision.h"
#include "core/base/types.h"

namespace shapespline {

/// How the keys are joined. The first is the method; the others are the baselines it is compared with.
enum class Method {
  Lri,          ///< cubic splines in LRI space (the method)
  Geodesic,     ///< piecewise linear in LRI space (Kilian et al. 2007, as in Fig. 1)
  Linear,       ///< piecewise linear vertex positions: what morph targets do
  CubicVertex,  ///< cubic splines of the vertex positions
};

enum class BoundaryKind { Natural, Hermite, Periodic };

/// How the symmetric factor S_f of a face is interpolated.
enum class Stretch {
  Linear,  ///< S_f itself (the paper); beyond the keys it eases off short of a lower limit and stays definite, a blend may not
  Log,     ///< log S_f; cannot turn inside out, and beyond the keys eases towards limits (stretch_limits.h)
};

/// How the full-resolution shape follows a ghost mesh (paper section 4.3).
enum class Transfer {
  Exact,  ///< what the keys show beyond the ghost's motion is splined too: passes through every key
  Paper,  ///< the reference's details follow the ghost; other keys are met up to their own details
};

/// Whole turns added on the way to a key, to the whole shape or to one component against the one that carries it.
struct AddedTurns {
  int key = 1;         ///< 0-based, at least 1: the turns happen between key - 1 and key
  int turns = 0;       ///< whole turns about the axis of that increment; negative turns go the other way
  int component = -1;  ///< 0-based, components counted by their first face in the file; -1: the whole shape
};

/// Choices that refit the spline only: changing them never encodes or factorises again.
struct MotionOptions {
  Method method = Method::Lri;
  BoundaryKind boundary = BoundaryKind::Natural;
  double startSpeed = 1;         ///< hermite: times the one-sided difference at the first key; 0 = ease
  double endSpeed = 1;           ///< hermite: the same at the last key
  std::optional<double> period;  ///< periodic: whole period in units of time; default: see BoundaryKind in spline.h
  std::vector<double> tension;   ///< empty, or J values: slope at a key = (1 - tension) * the C2 spline's own
  std::vector<double> bias;      ///< empty, or J values in [-1, 1]: from 0 to 1 the slope at a key goes over to the difference from
                                 ///< the key before, from 0 to -1 to that to the key after (at an end key to the only one)
  std::vector<AddedTurns> turns;
  bool inPlace = false;          ///< take out the translation that accumulates along the sequence
};

/// Choices that change the encoding: a new sequence is built for them.
struct EncodingOptions {
  int reference = 0;                     ///< 0-based key that deformation gradients are measured from
  int patches = 0;                       ///< wanted number of patches (of the ghost, with one), 0 = the default formula (patches.h)
  Stretch stretch = Stretch::Linear;
  int ghostFaces = 0;                    ///< 0 = off, else at least 4: the splines run on a ghost mesh of about so many faces
  Transfer transfer = Transfer::Exact;   ///< with a ghost
  bool optimalPlacement = false;         ///< ghost vertices need not be vertices of the shape (simplify.h)
  Precision precision = Precision::Single;
  std::optional<Positions> startTangent; ///< hermite: a shape that takes the place of key 2 in the difference at key 1
  std::optional<Positions> endTangent;   ///< hermite: a shape that takes the place of key J - 1 in the difference at key J
};

}  // namespace shapespline
