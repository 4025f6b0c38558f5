#include "core/hold/held_motion.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace shapespline {

namespace {

constexpr double degree = std::numbers::pi / 180;
constexpr double contactWeight = 30;  // times a vertex's share in the area
constexpr double leastAnchor = 1e-5, mostAnchor = 1e4, anchorTurn = 200 * degree;
// Turns of the whole from key to key over which the placement gives way: its target is a blend of vertices.
constexpr double turnsLittle = 30 * degree, turnsFar = 90 * degree;
constexpr double fitTurnsLittle = 60 * degree, fitTurnsFar = 120 * degree;
// How well the mean of rotations is defined: from 0 to 2.
constexpr double scattered = 0.1, gathered = 0.5;
constexpr double inertia = 1e-6;

}  // namespace

Result<std::shared_ptr<const HeldMotion>> HeldMotion::create(const HoldInput& input, const Curve& curve, Hold hold,
                                                             const HeldMotion* before) {
  std::shared_ptr<HeldMotion> held(new HeldMotion(input, curve, hold));
  const bool same = before && before->hold_ == hold && before->anchor_ == held->anchor_;
  if (same) {
    held->system_ = before->system_;
  } else {
    std::vector<double> weight = held->anchor_;
    if (hold == Hold::Contact)
      for (const double area : held->area_) weight.push_back(contactWeight * area);
    auto system = HoldSystem::create(input.mesh, weight, input.precision);
    if (!system) return system.error();
    held->system_ = std::make_shared<const HoldSystem>(std::move(*system));
  }
  // What rests is told by the keys and their times alone.
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
  resting_ = std::make_shared<const RestingPatches>(target_.path(), *system_, patchOf, patches, area_);
}

HeldMotion::HeldMotion(const HoldInput& input, const Curve& curve, Hold hold)
    : hold_(hold), turns_(input, curve), target_(input, curve, turns_), area_(vertexAreas(input.mesh)) {
  for (const double turn : turns_.wholeTurn) placed_.push_back(1 - fade(turn, turnsLittle, turnsFar));
  if (hold == Hold::Anchored) anchor_ = anchorWeights(input.mesh);
}

// The mean over its faces, by area, of what their frames' turns say.
std::vector<double> HeldMotion::anchorWeights(const HoldMesh& mesh) const {
  constexpr double leastTurn = 1e-9;
  const std::vector<double> faceArea = faceAreas(mesh);
  std::vector<double> weight(area_.size(), 0.0);
  for (std::size_t f = 0; f < faceArea.size(); ++f) {
    if (mesh.frameOf[f] < 0) continue;
    const double ratio = anchorTurn / std::max(turns_.frameTurn[mesh.frameOf[f]], leastTurn);
    for (const int v : mesh.shape.faces[f]) weight[v] += faceArea[f] / 3 * std::min(ratio * ratio, mostAnchor);
  }
  for (std::size_t v = 0; v < weight.size(); ++v) weight[v] = std::max(weight[v], leastAnchor * area_[v]);
  return weight;
}

double HeldMotion::placementShare(const SpanPlace& place, const Mat3& frameSum, const Mat3& mean) const {
  const double share = tween(placed_.data(), target_.path().spans(), target_.path().loop(), place);
  return share * place.within() * fade((mean.transpose() * frameSum).trace() - 1, scattered, gathered);
}

// A little inertia keeps a shape that is a line from spinning about itself. The shape turns about its centroid.
HeldMotion::Placement HeldMotion::place(const FitSums& sums, double share) const {
  const Mat3 fit = projectToRotation(sums.covariance + inertia * sums.covariance.norm() * Mat3::Identity());
  const Vec3 angle = logRotation(fit);
  const double taken = share * (1 - fade(angle.norm(), fitTurnsLittle, fitTurnsFar));
  const Mat3 turn = expRotation(taken * angle);
  return {turn, sums.from + taken * (sums.to - sums.from) - turn * sums.from};
}

void HeldMotion::apply(double t, const std::vector<Quaternion>& frames, const Vec3& mean, Positions& shape,
                       Scratch& scratch, ForkJoin* forkJoin) const {
  const SpanPlace place = target_.path().placeOf(t);
  if (place.beyond >= 1) return;
  const Mat3 sum = turns_.sumOf(frames), turn = projectToRotation(sum);
  target_.at(t, turn, mean, scratch.target, scratch.body);
  const Placement placed = this->place(fitSums(area_, mean, shape, scratch.target), placementShare(place, sum, turn));
  moveRigidly(placed.turn, placed.move, shape);
  if (hold_ == Hold::Anchored) anchor(place.within(), shape, scratch, forkJoin);
  if (resting_->weightsAt(place, scratch.weight)) holdPatches(shape, scratch, forkJoin);
}

void HeldMotion::anchor(double share, Positions& shape, Scratch& scratch, ForkJoin* forkJoin) const {
  scratch.vector.assign(system_->size(), 0.0);
  scatterWay(shape, scratch.target, anchor_, share, system_->slot(), scratch.vector);
  system_->solve(scratch.vector, scratch.solve, forkJoin);
  addGathered(scratch.vector, system_->slot(), shape);
}

void HeldMotion::holdPatches(Positions& shape, Scratch& scratch, ForkJoin* forkJoin) const {
  const std::vector<int>& handleOf = resting_->handleOf();
  const std::vector<double>& share = resting_->share();
  std::vector<Vec3>& pull = scratch.pull;
  pull.assign(resting_->count(), Vec3::Zero());
  addMeans(handleOf, share, shape, pull);
  for (Vec3& p : pull) p = -p;
  addMeans(handleOf, share, scratch.target, pull);
  for (std::size_t h = 0; h < pull.size(); ++h) pull[h] *= scratch.weight[h];
  resting_->pull(pull);
  scratch.vector.assign(system_->size(), 0.0);
  for (std::size_t v = 0; v < shape.size(); ++v)
    for (int k = 0; k < 3 && handleOf[v] >= 0; ++k)
      scratch.vector[system_->at(v) + k] = share[v] * pull[handleOf[v]][k];
  system_->solve(scratch.vector, scratch.solve, forkJoin);
  addGathered(scratch.vector, system_->slot(), shape);
}

}  // namespace shapespline
