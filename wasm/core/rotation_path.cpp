#include "core/rotation_path.h"

#include <numbers>

namespace shapespline {

namespace {

// Within this of half a turn the sign of the principal logarithm is decided by rounding.
constexpr double halfTurnMargin = 1e-3;

}  // namespace

RotationPath::RotationPath(std::vector<Quaternion> rotations) : rotations_(std::move(rotations)) {
  const int keys = keyCount();
  increments_.assign(keys + 1, Vec3::Zero());
  for (int i = 1; i <= keys; ++i) {
    const Vec3 principal = logRotation(Quaternion(rotations_[i - 1].conjugate() * rotations_[i % keys]));
    const bool ambiguous = principal.norm() > std::numbers::pi - halfTurnMargin;
    increments_[i] = ambiguous && i > 1 ? nearestRepresentative(principal, increments_[i - 1]) : principal;
  }
}

void RotationPath::setTangents(const Quaternion* start, const Quaternion* end) {
  if (start) startTangent_ = logRotation(Quaternion(rotations_.front().conjugate() * *start));
  if (end) endTangent_ = logRotation(Quaternion(rotations_.back().conjugate() * *end));
}

Quaternion RotationPath::at(const Weights& w) const {
  const Columns columns{keyCount()};
  const double startWeight = w[columns.startTangent()], endWeight = w[columns.endTangent()];
  // An end tangent is the end key plus a difference, so that its weight counts for that key too.
  double fromHere = w.sum() - startWeight - w[0];
  Quaternion rotation = rotations_.front();
  if (startWeight != 0) rotation = rotation * expQuaternion(startWeight * startTangent_);
  for (int i = 1; i < keyCount(); ++i) {
    rotation = rotation * expQuaternion(fromHere * increments_[i]);
    fromHere -= w[i];
  }
  if (endWeight != 0) rotation = rotation * expQuaternion(endWeight * endTangent_);
  if (w[columns.closing()] != 0) rotation = rotation * expQuaternion(w[columns.closing()] * increments_[keyCount()]);
  return rotation.normalized();
}

}  // namespace shapespline
