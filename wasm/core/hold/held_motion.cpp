#include "core/hold/held_motion.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace shapespline {

namespace {

constexpr double degree = std::numbers::pi / 180;
constexpr double minAnchor = 1e-5, maxAnchor = 1e4, anchorTurn = 200 * degree;
// Rotations of the whole between keys at which the rigid fit fades out, because its target is a blend of vertices.
constexpr double turnFadeStart = 30 * degree, turnFadeEnd = 90 * degree;
constexpr double fitFadeStart = 60 * degree, fitFadeEnd = 120 * degree;
// The fit fades in over this range of how well the mean rotation is defined, from 0 to 2.
constexpr double scattered = 0.1, gathered = 0.5;
constexpr double inertia = 1e-6;
// The fit fades in over this range of how well it is defined itself, from 0 to 1.
constexpr double openFit = 0.05, soundFit = 0.7;

// Regularises the fit of nearly collinear shapes.
Mat3 stiffened(const Mat3& covariance) { return covariance + inertia * covariance.norm() * Mat3::Identity(); }

// Product of the inertias about the three axes.
double resistance(const Mat3& covariance) { return (covariance.trace() * Mat3::Identity() - covariance).determinant(); }

// Resistance to rotating the fit, relative to the resistance if both shapes equalled their mean. 1 for equal shapes,
// less for different forms or sizes, 0 if an axis is undetermined. Smooth, because it is a symmetric function of the
// singular values.
double definedness(const FitSums& sums, const Mat3& fit) {
  const Mat3 between = fit.transpose() * stiffened(sums.covariance);
  const Mat3 mean = (sums.ofFrom + fit.transpose() * sums.ofTo * fit) / 2;
  const double share = resistance((between + between.transpose()) / 2) / (resistance(stiffened(mean)) + 1e-300);
  return std::sqrt(std::max(share, 0.0));
}

}  // namespace

Result<std::shared_ptr<const HeldMotion>> HeldMotion::create(const HoldInput& input, const Curve& curve,
                                                             const std::vector<AddedTurns>& turns,
                                                             const HeldMotion* before) {
  std::shared_ptr<HeldMotion> held(new HeldMotion(input, curve, turns));
  const bool same = before && before->anchor_ == held->anchor_;
  if (same) {
    held->system_ = before->system_;
  } else {
    auto system = HoldSystem::create(input.mesh, held->anchor_, input.precision);
    if (!system) return system.error();
    held->system_ = std::make_shared<const HoldSystem>(std::move(*system));
  }
  // Resting vertices depend only on the keys and their times.
  if (same && before->target_.path().hasSpansOf(held->target_.path())) held->resting_ = before->resting_;
  else held->findResting(input);
  return std::shared_ptr<const HeldMotion>(std::move(held));
}

void HeldMotion::findResting(const HoldInput& input) {
  std::vector<int> patchOf(area_.size(), -1);
  int patches = 0;
  for (std::size_t f = 0; f < input.patchOfFace.size(); ++f) {
    if (input.patchOfFace[f] < 0) continue;
    patches = std::max(patches, input.patchOfFace[f] + 1);
    for (const int v : input.mesh.shape.faces[f])
      if (patchOf[v] < 0) patchOf[v] = input.patchOfFace[f];
  }
  resting_ = std::make_shared<const ContactConstraints>(target_.path(), *system_, patchOf, patches, area_);
}

HeldMotion::HeldMotion(const HoldInput& input, const Curve& curve, const std::vector<AddedTurns>& turns)
    : target_(input, curve), area_(vertexAreas(input.mesh)), heldShare_(heldShares(curve, turns)) {
  for (const auto& body : target_.rigidGroups()) {
    std::vector<double>& share = placed_.emplace_back();
    for (const double turn : body->turns.wholeTurn) share.push_back(1 - smoothstep2(turn, turnFadeStart, turnFadeEnd));
  }
  anchor_ = anchorWeights(input.mesh);
}

// Area-weighted mean over each vertex's faces of the weights given by their frames' rotations.
std::vector<double> HeldMotion::anchorWeights(const HoldMesh& mesh) const {
  constexpr double minTurn = 1e-9;
  const std::vector<double> faceArea = faceAreas(mesh);
  const std::vector<double>& frameTurn = target_.rigidGroups()[0]->turns.frameTurn;
  std::vector<double> weight(area_.size(), 0.0);
  for (std::size_t f = 0; f < faceArea.size(); ++f) {
    if (mesh.localFrameOf[f] < 0) continue;
    const double ratio = anchorTurn / std::max(frameTurn[mesh.localFrameOf[f]], minTurn);
    for (const int v : mesh.shape.faces[f]) weight[v] += faceArea[f] / 3 * std::min(ratio * ratio, maxAnchor);
  }
  for (std::size_t v = 0; v < weight.size(); ++v) weight[v] = std::max(weight[v], minAnchor * area_[v]);
  return weight;
}

// Each rigid group rotates about its centroid.
void HeldMotion::moveOntoTarget(const SpanPosition& inSpan, const std::vector<Quaternion>& frames, const Vec3& mean,
                                const Positions& target, Positions& shape) const {
  for (std::size_t b = 0; b < placed_.size(); ++b) {
    const RestTarget::RigidGroup& body = *target_.rigidGroups()[b];
    const Mat3 sum = body.turns.sumOf(frames);
    const double defined = (projectToRotation(sum).transpose() * sum).trace() / body.turns.area - 1;
    const double share = blendSpans(placed_[b].data(), target_.path().spans(), target_.path().loop(), inSpan) *
                         inSpan.within() * smoothstep2(defined, scattered, gathered);
    const FitSums sums = fitSums(area_, mean, body.vertices, shape, target);
    const Mat3 fit = projectToRotation(stiffened(sums.covariance));
    const Vec3 angle = logRotation(fit);
    const double taken = share * (1 - smoothstep2(angle.norm(), fitFadeStart, fitFadeEnd)) *
                         smoothstep2(definedness(sums, fit), openFit, soundFit);
    const Mat3 turn = expRotation(taken * angle);
    moveRigidly(turn, sums.from + taken * (sums.to - sums.from) - turn * sums.from, body.vertices, shape);
  }
}

void HeldMotion::apply(double t, const std::vector<Quaternion>& frames, const Vec3& mean, Positions& shape,
                       Scratch& scratch, ForkJoin* forkJoin) const {
  SpanPosition inSpan = target_.path().spanPositionAt(t);
  if (!heldShare_.empty())
    inSpan.held = lesserOfSpans(heldShare_.data(), target_.path().spans(), target_.path().loop(), inSpan);
  if (inSpan.within() <= 0) return;
  target_.at(t, frames, mean, scratch.target, scratch.body);
  moveOntoTarget(inSpan, frames, mean, scratch.target, shape);
  const bool holds = resting_->weightsAt(inSpan, scratch.weight);
  pullsTo(shape, scratch.target, anchor_, inSpan.within(), scratch.pulls);
  const bool together = holds && !resting_->response().empty();
  if (!together) system_->addSolved(scratch.pulls, shape, scratch.solve, forkJoin);
  if (holds) holdPatches(together, shape, scratch, forkJoin);
}

// together: scratch.pulls still has the pulls towards the target positions, so one solve does both.
void HeldMotion::holdPatches(bool together, Positions& shape, Scratch& scratch, ForkJoin* forkJoin) const {
  std::vector<Vec3>& pull = scratch.pull;
  resting_->meanDisplacements(shape, scratch.target, pull);
  const std::vector<float>& response = resting_->response();
  if (together) takeResponse(response, scratch.pulls, pull);
  for (std::size_t h = 0; h < pull.size(); ++h) pull[h] *= scratch.weight[h];
  resting_->pull(pull);
  if (!together) scratch.pulls.assign(shape.size(), Vec3::Zero());
  resting_->addTo(scratch.pulls, pull);
  system_->addSolved(scratch.pulls, shape, scratch.solve, forkJoin);
}

}  // namespace shapespline
