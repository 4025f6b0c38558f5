#include "core/spline/rotation_spline.h"

#include <cassert>

namespace shapespline {

void RotationSplines::at(const CurvePoint& point, std::span<const WholeTurns> turns,
                         std::vector<Quaternion>& rotation) const {
  rotation = key[point.base];
  for (const StepShare& step : point.steps) {
    const std::vector<Vec3>& w = increment[step.step];
    assert(w.size() == rotation.size());
    for (std::size_t i = 0; i < w.size(); ++i) rotation[i] = rotation[i] * expQuaternion(step.share * w[i]);
    for (const WholeTurns& t : turns)
      if (t.step == step.step) rotation[t.path] = rotation[t.path] * expQuaternion(step.share * t.vector);
  }
  for (Quaternion& q : rotation) q.normalize();
}

}  // namespace shapespline
