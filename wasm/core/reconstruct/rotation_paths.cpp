#include "core/reconstruct/rotation_paths.h"

#include "core/reconstruct/lane_quaternion.h"

namespace shapespline {

namespace {

constexpr int incrementBlock = 3 * faceLanes;

constexpr std::size_t incrementAt(int slot, int k) {
  return static_cast<std::size_t>(slot / faceLanes) * incrementBlock + k * faceLanes + slot % faceLanes;
}

template <class L, class Real>
LaneQuaternion<L> expOf(const Real* increment, double share) {
  const L half = L::splat(static_cast<Real>(share / 2));
  return expOfHalves(half * L::load(increment), half * L::load(increment + faceLanes),
                     half * L::load(increment + 2 * faceLanes));
}

}  // namespace

template <class Real>
RotationPaths<Real>::RotationPaths(const RotationSplines& paths, KeySteps steps, std::span<const int> slotOf)
    : steps_(steps), blocks_((slotOf.size() + faceLanes - 1) / faceLanes) {
  const auto faces = static_cast<int>(slotOf.size());
  for (const std::vector<Quaternion>& rotations : paths.key) {
    RotationBlocks<Real>& key = key_.emplace_back(rotationNumbers(faces), Real(0));
    for (std::size_t slot = 0; slot < blocks_ * faceLanes; ++slot)
      setRotation(key, static_cast<int>(slot), Quaternion::Identity());
    for (int f = 0; f < faces; ++f) setRotation(key, slotOf[f], rotations[f]);
  }
  for (const std::vector<Vec3>& vectors : paths.increment) {
    std::vector<Real>& increment = increment_.emplace_back();
    if (vectors.empty()) continue;
    increment.assign(blocks_ * incrementBlock, Real(0));
    for (int f = 0; f < faces; ++f)
      for (int k = 0; k < 3; ++k) increment[incrementAt(slotOf[f], k)] = static_cast<Real>(vectors[f][k]);
  }
}

template <class Real>
Vec3 RotationPaths<Real>::increment(int step, int slot) const {
  const auto at = [&](int k) { return static_cast<double>(increment_[step][incrementAt(slot, k)]); };
  return {at(0), at(1), at(2)};
}

template <class Real>
void RotationPaths<Real>::at(const CurvePoint& point, const Quaternion& whole, RotationBlocks<Real>& rotations,
                             ForkJoin* forkJoin) const {
  rotations.resize(blocks_ * rotationBlock);
  const std::size_t middle = blocks_ / 2;
  inTwo(forkJoin, [&](int half) {
    blocksAt(point, whole, half == 0 ? 0 : middle, half == 0 ? middle : blocks_, rotations.data());
  });
}

// As RotationSplines::at, without added turns. A step's rotation is exp(C w) exp((C - 1) w)^-1.
template <class Real>
void RotationPaths<Real>::blocksAt(const CurvePoint& point, const Quaternion& whole, std::size_t begin, std::size_t end,
                                   Real* rotations) const {
  using L = Lanes<Real>;
  const RotationBlocks<Real>& base = key_[point.base];
  const bool turned = whole.w() != 1;
  for (std::size_t b = begin; b < end; ++b) {
    LaneQuaternion<L> forward = loadRotations<L>(&base[b * rotationBlock]);
    LaneQuaternion<L> end = forward, back = splat<L>(Quaternion::Identity());
    for (const StepShare& step : point.steps) {
      const Real* increment = &increment_[step.step][b * incrementBlock];
      const LaneQuaternion<L> part = expOf<L>(increment, step.share);
      const LaneQuaternion<L> rest = isTangent(step.step) ? part : expOf<L>(increment, step.share - 1);
      forward = forward * part;
      end = end * part * conjugate(rest);
      back = rest * back;
    }
    LaneQuaternion<L> q = forward + end * back;
    if (turned) q = splat<L>(whole) * q;
    storeUnit(q, rotations + b * rotationBlock);
  }
}

template class RotationPaths<float>;
template class RotationPaths<double>;

}  // namespace shapespline
