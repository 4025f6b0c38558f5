#include "core/space/rotation_strain_space.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "core/space/lifted_paths.h"

namespace shapespline {

namespace {

std::variant<RotationPaths<float>, RotationPaths<double>> pathsInOrderOf(const LriSpace& lri,
                                                                         const RotationSplines& paths) {
  using Paths = std::variant<RotationPaths<float>, RotationPaths<double>>;
  return lri.withReconstructor([&]<class Real>(const Reconstructor<Real>& r) -> Paths {
    std::vector<int> slotOf(paths.key.front().size());
    for (std::size_t f = 0; f < slotOf.size(); ++f) slotOf[f] = r.coordinates().face.slot(static_cast<int>(f));
    return RotationPaths<Real>(paths, slotOf);
  });
}

// The step that leads to a column from the one before it.
int stepTo(const WeldedShape& shape, int column) {
  const KeySteps steps{shape.keys};
  if (column == shape.startTangent) return steps.startTangent();
  return column == shape.endTangent ? steps.endTangent() : column - 1;
}

}  // namespace

RotationStrainSpace::RotationStrainSpace(const WeldedKeys& keys, const LriSpace& lri) : keys_(&keys), lri_(&lri) {
  LiftedPaths lifted = liftPaths(keys.shape, topologyOf(keys.shape));
  torn_ = std::move(lifted.torn);
  paths_ = pathsInOrderOf(lri, lifted.paths);
}

// Of a loop that ends elsewhere, which goes on from its last key.
Quaternion RotationStrainSpace::wholeTurn(const CurvePoint& point) const {
  const std::optional<RigidMotion>& closing = keys_->shape.closing;
  if (!closing || point.closes) return Quaternion::Identity();
  return Quaternion(closing->power(point.basePeriod).rotation);
}

Eigen::MatrixXd RotationStrainSpace::gramMatrix() const {
  const WeldedShape& shape = keys_->shape;
  const int columns = shape.columns();
  Eigen::MatrixXd gram = Eigen::MatrixXd::Zero(columns, columns);
  std::vector<double> entry(static_cast<std::size_t>(columns) * numbersPerFace);
  double total = 0;
  lri_->withReconstructor([&]<class Real>(const Reconstructor<Real>& r) {
    const FaceCoordinates<Real>& face = r.coordinates().face;
    for (int f = 0; f < shape.faceCount(); ++f) {
      if (lri_->patchOfFace()[f] < 0) continue;
      const double area = referenceFrame(shape, f).area;
      total += area;
      for (int c = 0; c < columns; ++c) {
        double* const numbers = &entry[static_cast<std::size_t>(c) * numbersPerFace];
        const double* const before = &entry[static_cast<std::size_t>(std::max(0, shape.before(c))) * numbersPerFace];
        const Vec3 increment = c == 0 ? Vec3(Vec3::Zero())
                                      : std::get<RotationPaths<Real>>(paths_).increment(stepTo(shape, c), face.slot(f));
        for (int k = 0; k < 3; ++k) numbers[k] = c == 0 ? 0 : before[k] + increment[k];
        for (int k = 3; k < numbersPerFace; ++k) numbers[k] = (k == 4 ? std::sqrt(2.0) : 1) * face.at(f, c, k);
      }
      addProducts(gram, area, entry);
    }
  });
  gram /= total;
  std::vector<double> mean(static_cast<std::size_t>(columns) * 3);
  for (int c = 0; c < columns; ++c)
    for (int k = 0; k < 3; ++k)
      mean[static_cast<std::size_t>(c) * 3 + k] = (keys_->meanPosition[c] - keys_->meanPosition[0])[k];
  addProducts(gram, 1 / (keys_->diagonal * keys_->diagonal), mean);
  return gram;
}

}  // namespace shapespline
