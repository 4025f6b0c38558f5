#include "core/spline/rotation_spline.h"

#include <cassert>

namespace shapespline {

void RotationSplines::finish(KeySteps steps) {
  stepRotation_.resize(increment.size());
  for (std::size_t s = 0; s < increment.size(); ++s) {
    stepRotation_[s].clear();
    if (static_cast<int>(s) == steps.startTangent() || static_cast<int>(s) == steps.endTangent()) continue;
    for (const Vec3& w : increment[s]) stepRotation_[s].push_back(expQuaternion(w));
  }
}

// The reversed keys start from their first key, R_e = R_b prod_s exp(w_s), and return by -w_s with shares 1 - C_s:
// B = R_e prod exp((C_s - 1) w_s), the last step first. A tangent's step does not lead to a key, so its share stays.
void RotationSplines::at(const CurvePoint& point, std::span<const WholeTurns> turns,
                         std::vector<Quaternion>& rotation) const {
  rotation.resize(key[point.base].size());
  for (std::size_t i = 0; i < rotation.size(); ++i) rotation[i] = pathAt(point, turns, i);
}

Quaternion RotationSplines::pathAt(const CurvePoint& point, std::span<const WholeTurns> turns, std::size_t path) const {
  Quaternion forward = key[point.base][path], end = forward, back = Quaternion::Identity();
  for (const StepShare& step : point.steps) {
    assert(path < increment[step.step].size());
    Quaternion part = expQuaternion(step.share * increment[step.step][path]), whole = Quaternion::Identity();
    if (!stepRotation_[step.step].empty()) whole = stepRotation_[step.step][path];
    for (const WholeTurns& t : turns)
      if (t.step == step.step && t.path == path) {
        part = part * expQuaternion(step.share * t.vector);
        whole = whole * expQuaternion(t.vector);
      }
    forward = forward * part;
    end = end * whole;
    back = part * whole.conjugate() * back;
  }
  return Quaternion(forward.coeffs() + (end * back).coeffs()).normalized();
}

}  // namespace shapespline
