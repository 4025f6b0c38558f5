#include "core/hold/turned_spans.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "core/hold/smoothstep.h"

namespace shapespline {

namespace {

// Overshoots at which holding fades out. Smaller ones are placed back by the rigid fit of held_motion.
constexpr double overshootsLittle = std::numbers::pi / 6, overshootsFar = std::numbers::pi / 3;
constexpr int timesPerSpan = 8;

// How far each step is from being not begun or complete.
std::vector<double> partsOf(const CurvePoint& point, int steps) {
  std::vector<double> part(steps, 0.0);
  for (const StepShare& step : point.steps) part[step.step] += std::min(std::abs(step.share), std::abs(step.share - 1));
  return part;
}

}  // namespace

std::vector<double> heldShares(const Curve& curve, const std::vector<AddedTurns>& turns) {
  std::vector<double> shares;
  int components = 0;
  bool any = false;
  for (const AddedTurns& added : turns) {
    components = std::max(components, added.component + 1);
    any |= added.turns != 0;
  }
  if (!any) return shares;
  const std::vector<KeySpan> spans = curve.spans();
  const KeySteps steps{static_cast<int>(spans.size()) + 1};
  for (const KeySpan& span : spans) {
    double most = 0;
    for (int i = 1; i < timesPerSpan; ++i) {
      const double t = span.start + (span.end - span.start) * i / timesPerSpan;
      std::vector<double> part = partsOf(curve.at(t), steps.count());
      // The last step of a loop that does not close in place.
      part[steps.keys - 2] = std::max(part[steps.keys - 2], part[steps.turnedClosing()]);
      std::vector<double> angle(components + 1, 0.0);  // of the whole and of each component
      for (const AddedTurns& added : turns) {
        const double share = added.key == span.to ? 1 : part[added.key - 1];
        most = std::max(most, angle[added.component + 1] += 2 * std::numbers::pi * std::abs(added.turns) * share);
      }
    }
    shares.push_back(1 - smoothstep2(most, overshootsLittle, overshootsFar));
  }
  return shares;
}

}  // namespace shapespline
