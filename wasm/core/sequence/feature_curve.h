// The motion as a curve of feature vectors: its plane, its bending energy, and the minimisation that it solves.
#pragma once

#include <functional>
#include <utility>
#include <vector>

#include <Eigen/Core>

#include "core/sequence/motion.h"

namespace shapespline {

/// Where the shapes of a sequence lie in the plane of the two leading principal components (Fig. 2b).
struct ShapePlane {
  std::vector<double> keys;  ///< 2J
  /// 2 values for each tangent shape there is, that of the start first.
  std::vector<double> tangents;
  std::vector<double> curve;  ///< 2 values for each of the asked times
  /// For each of them: how far the shape is from the plane, in the metric, as a share of the mean distance of keys that
  /// follow each other; 0 where all keys are equal.
  std::vector<double> distance;
  std::vector<double> weights;  ///< a row for each of them: a weight for each key, then for each tangent shape
  double explained = 0;         ///< share of the keys' variance that the plane holds, in [0, 1]
};

/// A face or a patch over time: rows of numbers, one for each of the asked times.
struct CoordinateCurve {
  int patch = -1;  ///< of a face: that it belongs to; -1 where it has no area, and nothing else is known then
  std::vector<int> neighbours;  ///< of a patch: those that it is linked with, components that are attached among them
  /// Of a face, 6: the rotation vector against its patch (radians) and S_f or log S_f as xx, xy, yy in the face's
  /// tangent frame (face_coordinates.h). Of a patch: the mean over its area of tr(S_f) / 2 or tr(log S_f) / 2, then
  /// for each neighbour j the rotation G^T G_j as w, x, y, z.
  std::vector<double> numbers;
  /// As `numbers`, of the natural cubic spline through the same keys: what the boundary and the shaping of the keys do.
  std::vector<double> natural;
};

/// Samples of the feature curve that minimise the bending energy with the keys held (paper Eq. 1-2, Fig. 2;
/// discrete_spline.h).
struct DiscretePath {
  std::vector<double> times;    ///< K; of a periodic motion those of one period
  std::vector<double> weights;  ///< K rows: a weight for each key, then for each tangent shape
  std::vector<double> plane;    ///< 2K: where the samples lie in the plane of ShapePlane
  double energy = 0;            ///< of the samples, in the metric of the feature vector; per unit of time cubed
  double curveEnergy = 0;       ///< of the curve's own shapes at the same times
};

/// How far the keys lie apart, and what keeps the curve from overshooting them.
struct KeySpacing {
  std::vector<double> distance;  ///< J - 1: |x_j - x_(j-1)|, without unit
  /// J, in [0, 1]: the least tension with which the slope at a key is at most three times that of either chord beside
  /// it (Fritsch and Carlson 1980, one bound for all coordinates, so the weights stay linear in the keys). 1 where two
  /// keys are equal: the motion rests there.
  std::vector<double> tension;
};

/// How the motion goes through shape space over time.
struct MotionSpeed {
  std::vector<double> speed;  ///< |x'(t)|, per unit of time; of a piecewise linear curve after a key, not before it
  /// How far the curve is past either of the keys beside it along the way from one to the other, relative to the mean
  /// distance of neighbouring keys; 0 between them, and beyond the first and last key.
  std::vector<double> overshoot;
};

/// What can be said of a motion from the inner products of its coordinates alone.
class FeatureCurve {
 public:
  /// The motion's shape at a time, one position per welded vertex (Evaluator::unmoved).
  using ShapeAt = std::function<void(double, Positions&)>;

  /// encoded: LRI space and that of the motion must have been made. gram: that of LRI space. All must outlive the
  /// curve.
  FeatureCurve(const EncodedShape& encoded, const Motion& motion, const Eigen::MatrixXd& gram, ShapeAt shapeAt)
      : encoded_(encoded),
        lri_(encoded.lri()),
        shape_(encoded.shape()),
        motion_(motion),
        gram_(gram),
        shapeAt_(std::move(shapeAt)) {}

  /// Shapes of other spaces are encoded for it, which costs about as much as a frame each.
  ShapePlane plane(const std::vector<double>& times) const;

  /// The minimisation that the splines solve in closed form, over K samples. With tensions, biases or a linear method,
  /// the curve is not its limit. Error: InvalidOption (too few samples or too many).
  Result<DiscretePath> discretePath(int samples) const;

  /// Bending energy density |x''(t)|^2 of the feature curve at each time (Eq. 6, Fig. 9), by second differences over a
  /// hundredth of the range, normalised by the mean deformation energy |x_j - x_(j-1)|^2 between keys. Corners of a
  /// piecewise linear curve appear as peaks. Vertex blends use the curve of their vertices: each method is measured in
  /// its own representation, as in the paper.
  std::vector<double> bendingEnergy(const std::vector<double>& times) const;

  KeySpacing keySpacing() const;

  MotionSpeed speedAt(const std::vector<double>& times) const;
  /// The coordinates of a face of the input as the motion's curve has them; of a blend of vertices those that the
  /// coordinates' own curve would have. Error: InvalidOption (no such face).
  Result<CoordinateCurve> face(int inputFace, const std::vector<double>& times) const;
  /// The same for a patch; with a ghost, for a patch of the ghost.
  Result<CoordinateCurve> patch(int patch, const std::vector<double>& times) const;

 private:
  Eigen::MatrixXd ownGram() const;
  ShapeProducts productsAt(double t, const Eigen::VectorXd& weights) const;
  double squaredLength(const Eigen::VectorXd& poseWeights) const;
  double squaredDistance(int key, int other) const;
  double overshoot(const Eigen::VectorXd& poseWeights, double t) const;
  double meanStep() const;
  Eigen::MatrixXd columnsToPoses() const;
  Eigen::VectorXd poseWeightsAt(const Curve& curve, double t) const;
  Eigen::VectorXd poseWeightsAt(double t) const { return poseWeightsAt(motion_.curve(), t); }

  const EncodedShape& encoded_;
  const LriSpace& lri_;
  const WeldedShape& shape_;
  const Motion& motion_;
  const Eigen::MatrixXd& gram_;
  ShapeAt shapeAt_;
};

}  // namespace shapespline
