// The motion as a curve of feature vectors: its plane, its bending energy, and the sampled minimisation.
#pragma once

#include <functional>
#include <utility>
#include <vector>

#include <Eigen/Core>

#include "core/sequence/motion.h"

namespace shapespline {

/// Positions of a sequence's shapes in the plane of the two leading principal components (Fig. 2b).
struct ShapePlane {
  std::vector<double> keys;  ///< 2J
  /// 2 values for each tangent pose, the start tangent first.
  std::vector<double> tangents;
  std::vector<double> curve;  ///< 2 values per requested time
  /// Per requested time: distance of the shape from the plane in the metric, relative to the mean distance of
  /// consecutive keys; 0 if all keys are equal.
  std::vector<double> distance;
  std::vector<double> weights;  ///< a row per requested time: a weight for each key, then for each tangent pose
  double explained = 0;         ///< share of the keys' variance in the plane, in [0, 1]
};

/// Coordinates of a face or a patch over time: one row of numbers per requested time.
struct CoordinateCurve {
  int patch = -1;               ///< for a face: its patch; -1 without area, in which case all else is empty
  std::vector<int> neighbours;  ///< for a patch: linked patches, including those of attached components
  /// For a face, 6 numbers: the rotation vector relative to its patch (radians), and S_f or log S_f as xx, xy, yy in
  /// the face's tangent frame (face_coordinates.h). For a patch: the area-weighted mean of tr(S_f) / 2 or tr(log S_f) /
  /// 2, then the rotation G^T G_j for each neighbour j as w, x, y, z.
  std::vector<double> numbers;
  /// As `numbers`, for the natural cubic spline through the same keys. The difference shows the effect of boundary and
  /// shaping.
  std::vector<double> natural;
};

/// Samples of the feature curve that minimise the bending energy and keep the keys (paper Eq. 1-2, Fig. 2;
/// discrete_spline.h).
struct DiscretePath {
  std::vector<double> times;    ///< K; for a periodic motion, those of one period
  std::vector<double> weights;  ///< K rows: a weight for each key, then for each tangent pose
  std::vector<double> plane;    ///< 2K: positions of the samples in the plane of ShapePlane
  double energy = 0;            ///< energy of the samples in the metric of the feature vector, per unit of time cubed
  double curveEnergy = 0;       ///< energy of the curve's shapes at the same times
};

/// Distances of the keys, and the tensions that prevent overshoot.
struct KeySpacing {
  std::vector<double> distance;  ///< J - 1: |x_j - x_(j-1)|, without unit
  /// J values in [0, 1]: the smallest tension for which the slope at a key is at most three times that of either
  /// adjacent chord (Fritsch and Carlson 1980, with one bound for all coordinates, so the weights stay linear in the
  /// keys). 1 if two keys are equal: the motion rests there.
  std::vector<double> tension;
};

/// Speed of the motion in shape space over time.
struct MotionSpeed {
  std::vector<double> speed;  ///< |x'(t)|, per unit of time; for a piecewise linear curve, the speed after a key
  /// Distance of the curve beyond either neighbouring key, along the line between them, relative to the mean distance
  /// of neighbouring keys. 0 between the keys, and beyond the first and last key.
  std::vector<double> overshoot;
};

/// Properties of a motion that follow from the inner products of its coordinates.
class FeatureCurve {
 public:
  /// The motion's shape at a given time, one position per welded vertex (Evaluator::unmoved).
  using ShapeAt = std::function<void(double, Positions&)>;

  /// encoded: LRI space and the motion's space must exist. gram: LRI space's. All arguments must outlive the curve.
  FeatureCurve(const EncodedShape& encoded, const Motion& motion, const Eigen::MatrixXd& gram, ShapeAt shapeAt)
      : encoded_(encoded),
        lri_(encoded.lri()),
        shape_(encoded.shape()),
        motion_(motion),
        gram_(gram),
        shapeAt_(std::move(shapeAt)) {}

  /// Shapes of other spaces are encoded first, at about the cost of one frame each.
  ShapePlane plane(const std::vector<double>& times) const;

  /// The plane with another motion's shape at t as its only point. The weights at t determine the representatives of
  /// its rotations and its mean position. positions: one per input vertex.
  ShapePlane planeWith(double t, const Positions& positions) const;

  /// The minimisation over K samples that the splines solve in closed form, without timing. With tensions, biases or a
  /// linear method, the curve is not its limit. Error: InvalidOption (too few or too many samples).
  Result<DiscretePath> discretePath(int samples) const;

  /// Bending energy density |x''(t)|^2 of the feature curve at each time (Eq. 6, Fig. 9), by second differences over a
  /// hundredth of the range, normalised by the mean deformation energy |x_j - x_(j-1)|^2 between keys. Corners of a
  /// piecewise linear curve appear as peaks. Vertex blends use the curve of their vertices: each method is measured in
  /// its own representation, as in the paper.
  std::vector<double> bendingEnergy(const std::vector<double>& times) const;

  KeySpacing keySpacing() const;

  MotionSpeed speedAt(const std::vector<double>& times) const;
  /// Coordinates of an input face along the motion's curve. For vertex blends, the curve of the coordinates is used.
  /// Error: InvalidOption (no such face).
  Result<CoordinateCurve> face(int inputFace, const std::vector<double>& times) const;
  /// Coordinates of a patch; with a ghost, of a patch of the ghost.
  Result<CoordinateCurve> patch(int patch, const std::vector<double>& times) const;

 private:
  Eigen::MatrixXd ownGram() const;
  // products: ShapeProducts of the shape at a time, which has these weights.
  template <class ProductsAt>
  ShapePlane planeOf(const std::vector<double>& times, const ProductsAt& products) const;
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
