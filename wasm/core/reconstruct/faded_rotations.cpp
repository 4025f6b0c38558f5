#include "core/reconstruct/faded_rotations.h"

#include "core/reconstruct/lane_quaternion.h"

namespace shapespline {

template <class Real>
void fadeRotations(const RotationBlocks<Real>& own, RotationBlocks<Real>& rotation, ForkJoin* forkJoin) {
  using L = Lanes<Real>;
  const std::size_t blocks = rotation.size() / rotationBlock, middle = blocks / 2;
  inTwo(forkJoin, [&](int half) {
    for (std::size_t b = half == 0 ? 0 : middle; b < (half == 0 ? middle : blocks); ++b) {
      Real* const at = &rotation[b * rotationBlock];
      const LaneQuaternion<L> r = loadRotations<L>(at);
      const LaneQuaternion<L> q = loadRotations<L>(&own[b * rotationBlock]) * conjugate(r);
      const L squared = q.w * q.w, share = squared * squared * q.w;
      storeUnit(expOfHalves(share * q.x, share * q.y, share * q.z) * r, at);
    }
  });
}

template void fadeRotations(const RotationBlocks<float>&, RotationBlocks<float>&, ForkJoin*);
template void fadeRotations(const RotationBlocks<double>&, RotationBlocks<double>&, ForkJoin*);

}  // namespace shapespline
