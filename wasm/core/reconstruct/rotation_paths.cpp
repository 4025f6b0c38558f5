#include "core/reconstruct/rotation_paths.h"

#include "core/base/simd.h"
#include "core/reconstruct/rodrigues.h"

namespace shapespline {

namespace {

constexpr int incrementBlock = 3 * faceLanes;

constexpr std::size_t incrementAt(int slot, int k) {
  return static_cast<std::size_t>(slot / faceLanes) * incrementBlock + k * faceLanes + slot % faceLanes;
}

template <class L>
struct Quaternions {
  L x, y, z, w;
};

template <class L>
Quaternions<L> operator*(const Quaternions<L>& a, const Quaternions<L>& b) {
  return {a.w * b.x + a.x * b.w + a.y * b.z - a.z * b.y, a.w * b.y - a.x * b.z + a.y * b.w + a.z * b.x,
          a.w * b.z + a.x * b.y - a.y * b.x + a.z * b.w, a.w * b.w - a.x * b.x - a.y * b.y - a.z * b.z};
}

template <class L, class Real>
Quaternions<L> loadRotations(const Real* q) {
  return {L::load(q), L::load(q + faceLanes), L::load(q + 2 * faceLanes), L::load(q + 3 * faceLanes)};
}

template <class L>
Quaternions<L> splat(const Quaternion& q) {
  const auto all = [](double x) { return L::splat(static_cast<typename L::Real>(x)); };
  return {all(q.x()), all(q.y()), all(q.z()), all(q.w())};
}

// exp of `share` times the increments: half the angle's sine and cosine.
template <class L, class Real>
Quaternions<L> expOf(const Real* increment, double share) {
  const L half = L::splat(static_cast<Real>(share / 2));
  const L x = half * L::load(increment), y = half * L::load(increment + faceLanes),
          z = half * L::load(increment + 2 * faceLanes), squared = x * x + y * y + z * z;
  const Rodrigues<Real> f = rodrigues<Real>(squared);
  return {f.a * x, f.a * y, f.a * z, L::splat(1) - squared * f.b};
}

template <class L, class Real>
void storeUnit(const Quaternions<L>& q, Real* to) {
  const L f = L::splat(1) / squareRoot(q.x * q.x + q.y * q.y + q.z * q.z + q.w * q.w);
  (f * q.x).store(to), (f * q.y).store(to + faceLanes);
  (f * q.z).store(to + 2 * faceLanes), (f * q.w).store(to + 3 * faceLanes);
}

}  // namespace

template <class Real>
RotationPaths<Real>::RotationPaths(const RotationSplines& paths, std::span<const int> slotOf)
    : blocks_((slotOf.size() + faceLanes - 1) / faceLanes) {
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

template <class Real>
void RotationPaths<Real>::blocksAt(const CurvePoint& point, const Quaternion& whole, std::size_t begin, std::size_t end,
                                   Real* rotations) const {
  using L = Lanes<Real>;
  const RotationBlocks<Real>& base = key_[point.base];
  const bool turned = whole.w() != 1;
  for (std::size_t b = begin; b < end; ++b) {
    Quaternions<L> q = loadRotations<L>(&base[b * rotationBlock]);
    for (const StepShare& step : point.steps) q = q * expOf<L>(&increment_[step.step][b * incrementBlock], step.share);
    if (turned) q = splat<L>(whole) * q;
    storeUnit(q, rotations + b * rotationBlock);
  }
}

template class RotationPaths<float>;
template class RotationPaths<double>;

}  // namespace shapespline
