#include "core/hold/rest_target.h"

#include <cmath>
#include <numbers>

#include "core/hold/hold_passes.h"

namespace shapespline {

namespace {

// What patches turn against the whole, as a share of what they turn: up to the first the motion is a rigid body's.
constexpr double rigid = 0.2, deforming = 0.35;

double angleOf(const Mat3& rotation) { return logRotation(rotation).norm(); }

Positions picked(const Positions& pose, const std::vector<int>& vertices) {
  Positions some;
  for (const int v : vertices) some.push_back(pose[v]);
  return some;
}

}  // namespace

KeyTurns::KeyTurns(const HoldInput& input, const Curve& curve) : frameArea(input.rotation.front().size(), 0.0) {
  const std::vector<double> faceArea = faceAreas(input.mesh);
  for (std::size_t f = 0; f < faceArea.size(); ++f)
    if (input.mesh.frameOf[f] >= 0) frameArea[input.mesh.frameOf[f]] += faceArea[f];
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
  deforms = fade(std::sqrt(turnedAgainst / (turned + still)), rigid, deforming);
}

Mat3 KeyTurns::sumOf(const std::vector<Quaternion>& frames) const {
  Mat3 sum = Mat3::Zero();
  for (std::size_t k = 0; k < frames.size(); ++k) sum += frameArea[k] * frames[k].toRotationMatrix();
  return sum;
}

RestTarget::RestTarget(const HoldInput& input, const Curve& curve, const KeyTurns& turns, const std::vector<int>* only)
    : deforms_(turns.deforms) {
  const WeldedShape* shape = &input.mesh.shape;
  const double diagonal = keyDiagonal(*shape);
  if (only) {
    std::vector<Positions> poses;
    for (const Positions& pose : shape->poses) poses.push_back(picked(pose, *only));
    some_ = shape->withMesh({}, std::move(poses));
    shape = &some_;
  }
  path_.emplace(*shape, curve, PathRest{PathRest::WhereStill, diagonal});
  if (deforms_ >= 1) return;
  // Every pose seen from the frame of the whole; there no period differs from another.
  body_ = shape->withMesh({}, shape->poses);
  body_.closing.reset();
  for (std::size_t pose = 0; pose < body_.poses.size(); ++pose)
    for (Vec3& p : body_.poses[pose]) p = turns.whole[pose].transpose() * (p - input.meanPosition[pose]);
  rigid_.emplace(body_, curve, PathRest{});
}

void RestTarget::at(double t, const Mat3& turn, const Vec3& mean, Positions& target, Positions& body) const {
  path_->positionsAt(t, target);
  if (!rigid_) return;
  rigid_->positionsAt(t, body);
  blendWithBody(deforms_, turn, mean, body, target);
}

}  // namespace shapespline
