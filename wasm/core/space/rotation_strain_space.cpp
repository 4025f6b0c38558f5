#include "core/space/rotation_strain_space.h"

#include <utility>

#include "core/space/lifted_paths.h"
#include "core/space/path_gram.h"

namespace shapespline {

namespace {

std::variant<RotationPaths<float>, RotationPaths<double>> pathsInOrderOf(const LriSpace& lri,
                                                                         const RotationSplines& paths, KeySteps steps) {
  using Paths = std::variant<RotationPaths<float>, RotationPaths<double>>;
  return lri.withReconstructor([&]<class Real>(const Reconstructor<Real>& r) -> Paths {
    std::vector<int> slotOf(paths.key.front().size());
    for (std::size_t f = 0; f < slotOf.size(); ++f) slotOf[f] = r.coordinates().face.slot(static_cast<int>(f));
    return RotationPaths<Real>(paths, steps, slotOf);
  });
}

}  // namespace

RotationStrainSpace::RotationStrainSpace(const WeldedKeys& keys, const LriSpace& lri) : keys_(&keys), lri_(&lri) {
  LiftedPaths lifted = liftPaths(keys.shape, topologyOf(keys.shape));
  torn_ = std::move(lifted.torn);
  paths_ = pathsInOrderOf(lri, lifted.paths, KeySteps{keys.shape.keys});
}

// For a loop that does not close in place, which continues from its last key.
Quaternion RotationStrainSpace::wholeTurn(const CurvePoint& point) const {
  const std::optional<RigidMotion>& closing = keys_->shape.closing;
  if (!closing || point.closes) return Quaternion::Identity();
  return Quaternion(closing->power(point.basePeriod).rotation);
}

Eigen::MatrixXd RotationStrainSpace::gramMatrix() const {
  return std::visit([&](const auto& paths) { return pathGram(*keys_, *lri_, paths, areaShares(*keys_, *lri_)); },
                    paths_);
}

}  // namespace shapespline
