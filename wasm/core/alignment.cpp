#include "core/alignment.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace shapespline {

namespace {

// Condition below which the mean rotation is not trusted: a twist by 270 degrees has 0.30, by 360 degrees 0, and the mean's
// derivative grows with the inverse. (The norm of the mean matrix would not do: of a twist by 360 degrees it is 0.58 of a
// rotation's, because the axis stays.)
constexpr double trustedCondition = 0.25;

// Index k of the representative angle + 2 pi k nearest `target`, where v is the principal rotation vector.
Vec3 shifted(const Vec3& v, int turns, const Vec3& axisHint) {
  const Vec3 axis = v.norm() > 1e-8 ? Vec3(v) : axisHint;
  // "One turn more" must mean the same sense for all patches: along the hint.
  const int sense = axis.dot(axisHint) < 0 ? -1 : 1;
  return addTurns(v, sense * turns, axisHint);
}

}  // namespace

Alignment::Alignment(const Input& in) : area_(in.patchArea), keys_(in.shape.keys) {
  std::vector<Quaternion> mean;
  for (int c = 0; c < in.shape.columns(); ++c) {
    RotationMean sum;
    for (int k = 0; k < in.patches.count; ++k) sum.add(in.rotation[c][k], area_[k]);
    mean.push_back(sum.mean());
    smallestCondition_ = std::min(smallestCondition_, sum.condition());
  }
  meanWithoutTurns_ = RotationPath({mean.begin(), mean.begin() + keys_});
  const int start = in.shape.startTangent, end = in.shape.endTangent;
  meanWithoutTurns_.setTangents(start >= 0 ? &mean[start] : nullptr, end >= 0 ? &mean[end] : nullptr);
  mean_ = meanWithoutTurns_;
  buildPatchPaths(in);
}

void Alignment::buildPatchPaths(const Input& in) {
  const int count = in.patches.count;
  patchWithoutTurns_.resize(count);
  for (int k = 0; k < count; ++k) {
    std::vector<Quaternion> keys;
    for (int j = 0; j < keys_; ++j) keys.push_back(in.rotation[j][k]);
    patchWithoutTurns_[k] = RotationPath(std::move(keys));
    const int start = in.shape.startTangent, end = in.shape.endTangent;
    patchWithoutTurns_[k].setTangents(start >= 0 ? &in.rotation[start][k] : nullptr,
                                      end >= 0 ? &in.rotation[end][k] : nullptr);
  }
  for (int i = 1; i <= keys_; ++i) {
    // Neighbours turn nearly alike: each patch takes the representative nearest its parent's, the parent's turn being
    // seen from the child's frame.
    for (int k : in.treeOrder) {
      const int parent = in.treeParent[k];
      if (parent < 0) continue;
      const Quaternion toChild = in.rotation[i - 1][k].conjugate() * in.rotation[i - 1][parent];
      const Vec3 target = toChild * patchWithoutTurns_[parent].increment(i);
      patchWithoutTurns_[k].setIncrement(i, nearestRepresentative(patchWithoutTurns_[k].increment(i), target));
    }
    // Which patch was the root must not matter: among common shifts by whole turns the smallest motion is taken.
    Vec3 axis = Vec3::Zero();
    double bestCost = 0;
    int bestTurns = 0;
    for (int k = 0; k < count; ++k)
      axis += area_[k] * (in.rotation[i - 1][k] * patchWithoutTurns_[k].increment(i));
    for (int k = 0; k < count; ++k) bestCost += area_[k] * patchWithoutTurns_[k].increment(i).squaredNorm();
    if (axis.norm() == 0) continue;
    const auto moved = [&](int k, int turns) {
      const Vec3 hint = in.rotation[i - 1][k].conjugate() * axis;
      return shifted(patchWithoutTurns_[k].increment(i), turns, hint);
    };
    for (int turns : {-1, 1, -2, 2, -3, 3}) {
      double cost = 0;
      for (int k = 0; k < count; ++k) cost += area_[k] * moved(k, turns).squaredNorm();
      if (cost < bestCost * (1 - 1e-9)) bestCost = cost, bestTurns = turns;
    }
    if (bestTurns != 0)
      for (int k = 0; k < count; ++k) patchWithoutTurns_[k].setIncrement(i, moved(k, bestTurns));
  }
  patch_ = patchWithoutTurns_;
}

void Alignment::decide(const std::vector<std::vector<Quaternion>>& sampled) {
  for (const auto& rotation : sampled) {
    RotationMean sum;
    for (std::size_t k = 0; k < rotation.size(); ++k) sum.add(rotation[k], area_[k]);
    smallestCondition_ = std::min(smallestCondition_, sum.condition());
  }
  byPatches_ = smallestCondition_ < trustedCondition;
}

void Alignment::setTurns(const std::vector<AddedTurns>& turns) {
  mean_ = meanWithoutTurns_;
  patch_ = patchWithoutTurns_;
  for (const AddedTurns& t : turns) {
    const Vec3 increment = mean_.increment(t.key);
    const Vec3 axis = increment.norm() > 1e-8 ? increment.normalized() : Vec3(Vec3::UnitY());
    mean_.setIncrement(t.key, addTurns(increment, t.turns, axis));
    for (RotationPath& path : patch_) {
      const Vec3 hint = path.key(t.key - 1).conjugate() * (mean_.key(t.key - 1) * axis);
      path.setIncrement(t.key, shifted(path.increment(t.key), t.turns, hint));
    }
  }
}

Quaternion Alignment::meanOf(const std::vector<Quaternion>& rotation) const {
  RotationMean sum;
  for (std::size_t k = 0; k < rotation.size(); ++k) sum.add(rotation[k], area_[k]);
  return sum.mean();
}

Quaternion Alignment::at(const Weights& weights, const std::vector<Quaternion>& rotation) const {
  if (!byPatches_) return mean_.at(weights) * meanOf(rotation).conjugate();
  RotationMean turn;
  for (std::size_t k = 0; k < rotation.size(); ++k) turn.add(patch_[k].at(weights) * rotation[k].conjugate(), area_[k]);
  return turn.mean();
}

double Alignment::largestIncrement() const {
  double largest = 0;
  for (int i = 1; i < keys_; ++i) {
    if (!byPatches_) {
      largest = std::max(largest, mean_.increment(i).norm());
      continue;
    }
    double smallest = std::numeric_limits<double>::infinity();  // the shape turns as a whole where every patch does
    for (const RotationPath& path : patch_) smallest = std::min(smallest, path.increment(i).norm());
    largest = std::max(largest, smallest);
  }
  return largest;
}

Quaternion Alignment::periodRotation() const {
  return mean_.key(keys_ - 1) * mean_.key(0).conjugate();
}

}  // namespace shapespline
