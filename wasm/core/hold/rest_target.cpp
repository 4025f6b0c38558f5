#include "core/hold/rest_target.h"

#include <cmath>

#include "core/base/centroid.h"
#include "core/hold/hold_passes.h"
#include "core/hold/rigid_groups.h"

namespace shapespline {

namespace {

// Rotation of patches relative to the whole, as a share of their total rotation. Up to the first limit, the motion is
// that of a rigid body.
constexpr double rigid = 0.2, deforming = 0.35;

double angleOf(const Mat3& rotation) { return logRotation(rotation).norm(); }

Positions picked(const Positions& pose, const std::vector<int>& vertices) {
  Positions some;
  for (const int v : vertices) some.push_back(pose[v]);
  return some;
}

}  // namespace

KeyRotations::KeyRotations(const HoldInput& input, const Curve& curve, const std::vector<int>& groupOf, int group)
    : frameArea(input.rotation.front().size(), 0.0) {
  const std::vector<double> faceArea = faceAreas(input.mesh);
  for (std::size_t f = 0; f < faceArea.size(); ++f) {
    const bool in = groupOf.empty() || groupOf[input.mesh.shape.faces[f][0]] == group;
    if (in && input.mesh.localFrameOf[f] >= 0) frameArea[input.mesh.localFrameOf[f]] += faceArea[f];
  }
  for (const double frame : frameArea) area += frame;
  for (const std::vector<Quaternion>& pose : input.rotation) whole.push_back(projectToRotation(sumOf(pose)));
  std::vector<double> own(frameArea.size(), 0.0);
  double turned = 0, turnedAgainst = 0;
  const std::vector<KeySpan> spans = curve.spans();
  for (const KeySpan& span : spans) {
    const Mat3 step = whole[span.to] * whole[span.from].transpose();
    wholeTurn.push_back(angleOf(step));
    for (std::size_t k = 0; k < own.size(); ++k) {
      const Mat3 turn = (input.rotation[span.to][k] * input.rotation[span.from][k].conjugate()).toRotationMatrix();
      const double angle = angleOf(turn), against = angleOf(step.transpose() * turn);
      own[k] += angle * angle / static_cast<double>(spans.size());
      turned += frameArea[k] * angle * angle;
      turnedAgainst += frameArea[k] * against * against;
    }
  }
  for (const double square : own) frameTurn.push_back(std::sqrt(square));
  constexpr double still = 1e-12;
  deforms = smoothstep2(std::sqrt(turnedAgainst / (turned + still)), rigid, deforming);
}

Mat3 KeyRotations::sumOf(const std::vector<Quaternion>& frames) const {
  Mat3 sum = Mat3::Zero();
  for (std::size_t k = 0; k < frames.size(); ++k) sum += frameArea[k] * frames[k].toRotationMatrix();
  return sum;
}

RestTarget::RestTarget(const HoldInput& input, const Curve& curve, const std::vector<int>* only) {
  const WeldedShape* shape = &input.mesh.shape;
  const double size = keySize(*shape);
  const std::vector<int> groupOf = only ? std::vector<int>(shape->poses[0].size(), 0) : rigidGroupsOf(input.mesh);
  for (std::size_t v = 0; v < groupOf.size(); ++v) {
    if (groupOf[v] == static_cast<int>(rigidGroups_.size()))
      rigidGroups_.emplace_back(new RigidGroup{KeyRotations(input, curve, groupOf, groupOf[v]), {}});
    rigidGroups_[groupOf[v]]->vertices.push_back(static_cast<int>(v));
  }
  std::vector<Vec3> mean;
  for (const std::unique_ptr<RigidGroup>& group : rigidGroups_)
    for (const Positions& pose : shape->poses) mean.push_back(centroidOf(picked(pose, group->vertices)));
  if (only) {
    std::vector<Positions> poses;
    for (const Positions& pose : shape->poses) poses.push_back(picked(pose, *only));
    some_ = shape->withMesh({}, std::move(poses));
    shape = &some_;
    rigidGroups_[0]->vertices.resize(only->size());  // 0, 1, ...
  }
  path_.emplace(*shape, curve, PathRest{PathRest::WhereStill, size});
  const Vec3* meanOf = mean.data();
  for (const std::unique_ptr<RigidGroup>& group : rigidGroups_) {
    const KeyRotations& turns = group->turns;
    if (turns.deforms < 1) {
      // Poses relative to the frame of the rigid group. In this frame, all periods are equal.
      group->shape = shape->withMesh({}, {});
      group->shape.closing.reset();
      for (std::size_t pose = 0; pose < shape->poses.size(); ++pose) {
        Positions& seen = group->shape.poses.emplace_back(picked(shape->poses[pose], group->vertices));
        for (Vec3& p : seen) p = turns.whole[pose].transpose() * (p - meanOf[pose]);
      }
      group->path.emplace(group->shape, curve, PathRest{});
    }
    meanOf += shape->poses.size();
  }
}

void RestTarget::at(double t, const std::vector<Quaternion>& frames, const Vec3& mean, Positions& target,
                    Positions& scratch) const {
  path_->positionsAt(t, target);
  for (const std::unique_ptr<RigidGroup>& group : rigidGroups_) {
    if (!group->path) continue;
    group->path->positionsAt(t, scratch);
    const Vec3 own = rigidGroups_.size() > 1 ? centroidOf(picked(target, group->vertices)) : mean;
    blendWithGroup(group->turns.deforms, projectToRotation(group->turns.sumOf(frames)), own, scratch, group->vertices,
                   target);
  }
}

}  // namespace shapespline
