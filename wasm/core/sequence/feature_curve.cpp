#include "core/sequence/feature_curve.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "core/base/format.h"
#include "core/space/gram_matrix.h"
#include "core/spline/discrete_spline.h"

namespace shapespline {

// Maps weights over the curve's columns, as a row, to weights over the poses.
Eigen::MatrixXd FeatureCurve::columnsToPoses() const {
  const Columns columns{shape_.keys};
  const int count = columns.count();
  Eigen::MatrixXd map(count, shape_.columns());
  for (int c = 0; c < count; ++c) {
    const PoseWeights w = poseWeights(blendedPoint(Eigen::VectorXd::Unit(count, c), columns), shape_.roles());
    map.row(c) = Eigen::Map<const Eigen::RowVectorXd>(w.column.data(), shape_.columns());
  }
  return map;
}

Eigen::VectorXd FeatureCurve::poseWeightsAt(const Curve& curve, double t) const {
  const PoseWeights w = poseWeights(curve.at(curve.wrap(t).time), shape_.roles());
  return Eigen::Map<const Eigen::VectorXd>(w.column.data(), static_cast<Eigen::Index>(w.column.size()));
}

template <class ProductsAt>
ShapePlane FeatureCurve::planeOf(const std::vector<double>& times, const ProductsAt& products) const {
  const PrincipalPlane plane(gram_, shape_.keys);
  ShapePlane result;
  result.explained = plane.explained();
  const auto append = [](std::vector<double>& list, const Vec2& p) { list.insert(list.end(), {p.x(), p.y()}); };
  for (int c = 0; c < shape_.columns(); ++c)
    append(c < shape_.keys ? result.keys : result.tangents, plane.project(Eigen::VectorXd::Unit(shape_.columns(), c)));
  const double step = meanStep();
  for (double t : times) {
    const Eigen::VectorXd weights = poseWeightsAt(t);
    const ShapeProducts at = products(plane, t, weights);
    append(result.curve, plane.project(at));
    result.distance.push_back(step > 0 ? plane.distance(at) / step : 0);
    result.weights.insert(result.weights.end(), weights.begin(), weights.end());
  }
  return result;
}

ShapePlane FeatureCurve::plane(const std::vector<double>& times) const {
  return planeOf(times, [&](const PrincipalPlane& plane, double t, const Eigen::VectorXd& weights) {
    if (motion_.inLri()) return plane.productsOf(weights);
    Positions positions;
    shapeAt_(t, positions);
    return lri_.productsOf(positions, weights);
  });
}

ShapePlane FeatureCurve::planeWith(double t, const Positions& positions) const {
  const std::vector<int>& weldedOf = encoded_.input().welding.weldedOfRaw;
  Positions welded(shape_.poses.front().size());
  for (std::size_t v = 0; v < positions.size(); ++v) welded[weldedOf[v]] = positions[v];
  return planeOf({t}, [&](const PrincipalPlane&, double, const Eigen::VectorXd& weights) {
    return lri_.productsOf(welded, weights);
  });
}

double FeatureCurve::meanStep() const {
  double sum = 0;
  for (int j = 1; j < shape_.keys; ++j) sum += std::sqrt(squaredDistance(j, j - 1));
  return sum / (shape_.keys - 1);
}

Result<CoordinateCurve> FeatureCurve::face(int inputFace, const std::vector<double>& times) const {
  if (inputFace < 0 || inputFace >= static_cast<int>(lri_.patchOfInputFace().size()))
    return Error{ErrorCode::InvalidOption, "There is no face " + grouped(inputFace) + " (counted from 0)."};
  CoordinateCurve result;
  result.patch = lri_.patchOfInputFace()[inputFace];
  if (result.patch < 0) return result;
  const Eigen::MatrixXd columns = lri_.faceColumns(inputFace);
  const Curve natural = motion_.naturalCurve();
  for (const Curve* curve : {&motion_.curve(), &natural}) {
    std::vector<double>& rows = curve == &natural ? result.natural : result.numbers;
    for (double t : times) {
      const Eigen::VectorXd six = columns * poseWeightsAt(*curve, t);
      rows.insert(rows.end(), six.begin(), six.end());
    }
  }
  return result;
}

Result<CoordinateCurve> FeatureCurve::patch(int patch, const std::vector<double>& times) const {
  const PatchCoordinates& patches = lri_.patches().coordinates();
  if (patch < 0 || patch >= patches.patches.count)
    return Error{ErrorCode::InvalidOption, "There is no patch " + grouped(patch) + " (counted from 0)."};
  CoordinateCurve result;
  const std::vector<PatchLink>& links = patches.graph.links();
  for (const PatchLink& link : links)
    if (link.from == patch || link.to == patch) result.neighbours.push_back(link.from + link.to - patch);
  const Eigen::VectorXd stretch = lri_.patchStretch(patch);
  const Curve natural = motion_.naturalCurve();
  std::vector<Quaternion> rotation;
  for (const Curve* curve : {&motion_.curve(), &natural}) {
    std::vector<double>& rows = curve == &natural ? result.natural : result.numbers;
    for (double t : times) {
      rows.push_back(stretch.dot(poseWeightsAt(*curve, t)));
      patches.connection.at(curve->at(curve->wrap(t).time), motion_.turns().bridges, rotation);
      for (std::size_t l = 0; l < links.size(); ++l) {
        const int sign = links[l].from == patch ? 1 : -1;  // in the other direction, the rotation is conjugated
        if (sign < 0 && links[l].to != patch) continue;
        const Quaternion& q = rotation[l];
        rows.insert(rows.end(), {q.w(), sign * q.x(), sign * q.y(), sign * q.z()});
      }
    }
  }
  return result;
}

Result<DiscretePath> FeatureCurve::discretePath(int samples) const {
  const Curve plain = motion_.curve().withoutTiming();
  const Result<DiscreteSpline> spline =
      DiscreteSpline::fit(motion_.keyTimes(), motion_.options().boundary, plain, samples);
  if (!spline) return spline.error();
  const PrincipalPlane plane(gram_, shape_.keys);
  const Eigen::MatrixXd toPoses = columnsToPoses(), columnGram = product(product(toPoses, gram_), toPoses.transpose());
  Eigen::MatrixXd curve(samples, toPoses.rows());
  DiscretePath path;
  path.times = spline->times();
  for (int i = 0; i < samples; ++i) {
    curve.row(i) = plain.weights(path.times[i]).transpose();
    const Eigen::VectorXd weights = toPoses.transpose() * spline->weights().row(i).transpose();
    path.weights.insert(path.weights.end(), weights.begin(), weights.end());
    const Vec2 p = plane.project(weights);
    path.plane.insert(path.plane.end(), {p.x(), p.y()});
  }
  path.energy = spline->energy(spline->weights(), columnGram);
  path.curveEnergy = spline->energy(curve, columnGram);
  return path;
}

double FeatureCurve::squaredLength(const Eigen::VectorXd& poseWeights) const {
  return std::max(0.0, poseWeights.dot(gram_ * poseWeights));
}

double FeatureCurve::squaredDistance(int key, int other) const {
  Eigen::VectorXd step = Eigen::VectorXd::Zero(shape_.columns());
  step[key] = 1;
  step[other] = -1;
  return squaredLength(step);
}

KeySpacing FeatureCurve::keySpacing() const {
  constexpr double steepest = 3;
  const std::vector<double>& times = motion_.keyTimes();
  const Curve smooth = motion_.unshapedCurve(shape_);
  const Eigen::MatrixXd toPoses = columnsToPoses();
  const double none = std::numeric_limits<double>::infinity();
  KeySpacing spacing;
  std::vector<double> chord = {none};  // slope before each key, and after the last
  for (int j = 1; j < shape_.keys; ++j) {
    spacing.distance.push_back(std::sqrt(squaredDistance(j, j - 1)));
    chord.push_back(spacing.distance.back() / (times[j] - times[j - 1]));
  }
  chord.push_back(none);
  for (int j = 0; j < shape_.keys; ++j) {
    const Eigen::VectorXd slope = toPoses.transpose() * smooth.weights(times[j], 1);
    const double length = std::sqrt(squaredLength(slope)), most = steepest * std::min(chord[j], chord[j + 1]);
    spacing.tension.push_back(length > most ? 1 - most / length : 0);
  }
  return spacing;
}

MotionSpeed FeatureCurve::speedAt(const std::vector<double>& times) const {
  const Eigen::MatrixXd toPoses = columnsToPoses();
  double average = 0;
  for (int j = 1; j < shape_.keys; ++j) average += std::sqrt(squaredDistance(j, j - 1)) / (shape_.keys - 1);
  MotionSpeed motion;
  for (double t : times) {
    const double inside = motion_.curve().wrap(t).time;
    motion.speed.push_back(std::sqrt(squaredLength(toPoses.transpose() * motion_.curve().weights(inside, 1))));
    motion.overshoot.push_back(average > 0 ? overshoot(poseWeightsAt(t), inside) / average : 0);
  }
  return motion;
}

// For equal keys, which have no direction between them, returns the distance from them.
double FeatureCurve::overshoot(const Eigen::VectorXd& poseWeights, double t) const {
  const std::vector<double>& times = motion_.keyTimes();
  const int after = static_cast<int>(std::upper_bound(times.begin(), times.end(), t) - times.begin());
  const bool closing = after == shape_.keys && motion_.curve().periodic();
  if (after == 0 || (after == shape_.keys && !closing)) return 0;
  const int from = after - 1, to = closing ? 0 : after;
  const double chord = std::sqrt(squaredDistance(to, from));
  Eigen::VectorXd way = poseWeights;
  way[from] -= 1;
  if (chord == 0) return std::sqrt(squaredLength(way));
  const double along = (gram_.col(to) - gram_.col(from)).dot(way) / chord;
  return std::max({0.0, -along, along - chord});
}

// Inner products in the motion's own space.
Eigen::MatrixXd FeatureCurve::ownGram() const {
  switch (motion_.options().method) {
    case Method::Linear:
    case Method::CubicVertex: return lri_.vertexGram();
    case Method::RotationStrain: return encoded_.rotationStrain().gramMatrix();
    case Method::Rimd: return encoded_.rimd().gramMatrix();
    case Method::Lri:
    case Method::Geodesic: break;
  }
  return gram_;
}

std::vector<double> FeatureCurve::bendingEnergy(const std::vector<double>& times) const {
  const Eigen::MatrixXd gram = ownGram();
  const auto squared = [&](const Eigen::VectorXd& weights) { return std::max(0.0, weights.dot(gram * weights)); };
  double average = 0;
  for (int j = 1; j < shape_.keys; ++j) {
    const Eigen::VectorXd step =
        Eigen::VectorXd::Unit(shape_.columns(), j) - Eigen::VectorXd::Unit(shape_.columns(), j - 1);
    average += squared(step) / (shape_.keys - 1);
  }
  const double h = (motion_.curve().end() - motion_.curve().start()) / 100;
  std::vector<double> result;
  for (double t : times) {
    const Eigen::VectorXd second = (poseWeightsAt(t - h) - 2 * poseWeightsAt(t) + poseWeightsAt(t + h)) / (h * h);
    result.push_back(average > 0 ? squared(second) / average : 0);
  }
  return result;
}

}  // namespace shapespline
