// The facade: keyframes and options in, the shape at any time out.
#pragma once

#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "core/base/fork_join.h"
#include "core/sequence/keyframes.h"
#include "core/sequence/options.h"
#include "core/rotation/rotation.h"
#include "core/sequence/sequence_stats.h"
#include "core/base/status.h"
#include "core/base/warning.h"

namespace shapespline {

/// Called with a stage's name and the fraction of the whole work done, in [0, 1] and never falling.
using Progress = std::function<void(const char* stage, double fraction)>;

/// One shape of the sequence, in the input's own vertices.
struct Frame {
  std::vector<float> positions;  ///< 3n, xyz interleaved
  std::vector<float> normals;    ///< 3n, unit, xyz interleaved
  int lostDefiniteness = 0;      ///< faces whose interpolated S_f is not positive definite
  int lostFace = -1;             ///< one of them, of the input; -1 where there is none
};

/// How far the preview's vertices are from the shape's, as a share of the reference pose's diagonal.
struct PreviewError {
  double mean = 0, largest = 0;
};

/// The coarse mesh that leads the motion (paper section 4.3, Fig. 6), and how the input belongs to it.
struct Ghost {
  std::vector<Triangle> faces;       ///< of ghost vertices; none without a ghost
  std::vector<int> vertexOf;         ///< of each ghost vertex: the corresponding vertex of the input
  std::vector<int> ghostVertexOf;    ///< of each vertex of the input: the ghost vertex that it collapsed to, or -1
  std::vector<int> ghostFaceOf;      ///< of each face of the input: the ghost face that it follows; -1 without area
};

/// Where the shapes of a sequence lie in the plane of the two leading principal components (Fig. 2b).
struct ShapePlane {
  std::vector<double> keys;   ///< 2J
  std::vector<double> curve;  ///< 2 values for each of the asked times
  double explained = 0;       ///< share of the keys' variance that the plane holds, in [0, 1]
};

/// Samples of the feature curve that minimise the bending energy with the keys held (paper Eq. 1-2, Fig. 2; discrete_spline.h).
struct DiscretePath {
  std::vector<double> times;    ///< K; of a periodic motion those of one period
  std::vector<double> weights;  ///< K rows: a weight for each key, then for each tangent shape
  std::vector<double> plane;    ///< 2K: where the samples lie in the plane of ShapePlane
  double energy = 0;            ///< of the samples, in the metric of the feature vector; per unit of time cubed
  double curveEnergy = 0;       ///< of the curve's own shapes at the same times
};

/// A completed motion. Built once (weld, encode, factorise), then evaluated at any time; evaluate is a pure function of
/// keys, options and t, bit for bit. Not thread-safe.
class Sequence {
 public:
  static Result<Sequence> create(Keyframes keyframes, const EncodingOptions& encoding, const MotionOptions& motion,
                                 const Progress& progress = {});

  Sequence(Sequence&&) noexcept;
  Sequence& operator=(Sequence&&) noexcept;
  ~Sequence();

  /// Refits the spline. Errors: InvalidOption, TimesNotIncreasing, TimeCountMismatch; the old motion stays then.
  Status update(const MotionOptions& motion, const std::vector<double>& keyTimes);

  /// The shape at time t, which may lie beyond the keys.
  Status evaluate(double t, Frame& frame);

  /// Frames are made by two from here on, to the same bits, or by one with null. The crew must outlive the sequence.
  void setCrew(Crew* crew);

  /// The same as n positions without rounding them to float: for measures and tests. As exact as the encoding's precision.
  Status evaluate(double t, Positions& positions);

  /// The shape at time t, about, in about half the time from 332,000 faces on, for while a slider moves. Meets every key; how far
  /// it is off between and beyond them depends on the motion: ask previewError. Measured on real shapes (wasm/core/README.md): 0.02 to
  /// 5 % of the diagonal in the mean between the keys, and up to 18 % at one place.
  /// lostDefiniteness is not counted. The baselines are exact.
  Status preview(double t, Frame& frame);

  /// What preview(t) is off. Costs one evaluation and one preview, in one thread.
  Result<PreviewError> previewError(double t);

  /// The shape at an affine combination of the keys: one weight a key, sum 1. evaluate(t) is this at the curve's weights.
  Status evaluateBlend(const std::vector<double>& weights, Frame& frame);

  /// The ghost that belongs to the shape at time t: xyz of each ghost vertex. Error: InvalidOption without a ghost.
  Status evaluateGhost(double t, std::vector<float>& positions);
  const Ghost& ghost() const;

  const Keyframes& keyframes() const;
  const MotionOptions& motion() const;
  SequenceStats stats() const;
  const std::vector<Warning>& warnings() const;

  /// First and last time at which the curve is defined by keys (for periodic: one whole period).
  std::pair<double, double> range() const;

  /// Patch index of each raw face, in [0, stats().patches); -1 for faces without area.
  const std::vector<int>& patchOfFace() const;

  /// Component of each raw face, in [0, stats().components), numbered by their first faces; -1 for faces without area.
  const std::vector<int>& componentOfFace() const;

  /// The rotations G_k of the patches (of the ghost, with one) at time t, as the first system gives them and the whole is turned.
  Status patchRotations(double t, std::vector<Quaternion>& rotations);

  ShapePlane shapePlane(const std::vector<double>& times);

  /// The minimisation that the splines solve in closed form, done by K samples. With tensions, biases or a linear method the curve is
  /// another one than its limit. Error: InvalidOption (too few samples or too many).
  Result<DiscretePath> discretePath(int samples);

  /// Bending energy density |x''(t)|^2 of the feature curve at each time (Eq. 6, Fig. 9), by second differences over a
  /// hundredth of the range and normalised by the average deformation energy |x_j - x_(j-1)|^2 between keys. Corners of a
  /// piecewise linear curve show as peaks.
  std::vector<double> bendingEnergy(const std::vector<double>& times);

 private:
  struct State;
  explicit Sequence(std::unique_ptr<State> state);
  std::unique_ptr<State> state_;
};

}  // namespace shapespline
