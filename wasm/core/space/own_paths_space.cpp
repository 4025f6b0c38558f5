#include "core/space/own_paths_space.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <utility>

#include "core/patches/patch_coordinates.h"
#include "core/reconstruct/faded_rotations.h"

namespace shapespline {

namespace {

constexpr std::array<double, 3> shares = {0.25, 0.5, 0.75};
// If the difference is smaller at all shares, no other full turn can be nearer.
constexpr double surelyNearest = std::numbers::pi / 4;

// The local frame with the largest area.
int largestFrame(const WeldedShape& shape, const std::vector<int>& localFrameOf, std::size_t frames) {
  std::vector<double> area(frames, 0);
  for (int f = 0; f < shape.faceCount(); ++f)
    if (localFrameOf[f] >= 0) area[localFrameOf[f]] += referenceFrame(shape, f).area;
  return static_cast<int>(std::max_element(area.begin(), area.end()) - area.begin());
}

// A point part way through one step.
CurvePoint pointOn(const WeldedShape& shape, int step, double share) {
  const KeySteps steps{shape.keys};
  const Columns columns{shape.keys};
  const auto [from, to] = posesOf(shape, step);
  const auto columnOf = [&](int pose) {
    if (pose == shape.startTangent) return columns.startTangent();
    return pose == shape.endTangent ? columns.endTangent() : pose;
  };
  CurvePoint point;
  point.weights = Weights::Zero(columns.count());
  point.weights[columnOf(from)] = 1 - share;
  point.weights[columnOf(to)] = share;
  point.base = from;
  point.steps = {{step, share, 0}};
  point.closes = step == steps.closing();
  return point;
}

class PathFinder {
 public:
  PathFinder(const WeldedShape& shape, const LriSpace& lri, int root) : shape_(shape), lri_(lri), root_(root) {}

  RotationSplines run() {
    const KeySteps steps{shape_.keys};
    for (int c = 0; c < shape_.columns(); ++c) out_.key.push_back(keyOf(c));
    out_.increment.resize(steps.count());
    for (int s = 0; s < steps.count(); ++s)
      if (s != steps.turnedClosing() && posesOf(shape_, s).from >= 0) findIncrements(s);
    if (shape_.closing) closeOnFirstKey();
    return std::move(out_);
  }

 private:
  bool isUsed(int f) const { return lri_.patchOfFace()[f] >= 0; }

  // Rotation of the base frame.
  Quaternion baseOf(int column) const {
    return root_ < 0 ? Quaternion::Identity() : lri_.holdInput().rotation[column][root_];
  }

  std::vector<Quaternion> keyOf(int column) const {
    const Quaternion back = baseOf(column).conjugate();
    std::vector<Quaternion> key(static_cast<std::size_t>(shape_.faceCount()), Quaternion::Identity());
    for (int f = 0; f < shape_.faceCount(); ++f)
      if (isUsed(f)) key[f] = (back * rotationOf(shape_, f, column)).normalized();
    return key;
  }

  void findIncrements(int step) {
    std::array<std::vector<Quaternion>, shares.size()> wanted;
    LriSpace::Scratch scratch;
    LocalFrames frames;
    for (std::size_t i = 0; i < shares.size(); ++i) {
      const CurvePoint point = pointOn(shape_, step, shares[i]);
      lri_.localFramesAt(point, {}, scratch, frames);
      lri_.withReconstructor([&](const auto& r) { r.faceRotations(point, frames, wanted[i]); });
      if (root_ >= 0)
        for (Quaternion& q : wanted[i]) q = frames.rotation[root_].conjugate() * q;
    }
    const auto [from, to] = posesOf(shape_, step);
    std::vector<Vec3>& increment = out_.increment[step];
    increment.assign(static_cast<std::size_t>(shape_.faceCount()), Vec3::Zero());
    for (int f = 0; f < shape_.faceCount(); ++f) {
      if (!isUsed(f)) continue;
      const Quaternion& start = out_.key[from][f];
      const std::array<Quaternion, 3> onTheWay = {wanted[0][f], wanted[1][f], wanted[2][f]};
      increment[f] = nearest(start, logRotation(Quaternion(start.conjugate() * out_.key[to][f])), onTheWay);
    }
  }

  static Vec3 nearest(const Quaternion& start, const Vec3& principal, const std::array<Quaternion, 3>& wanted) {
    Vec3 best = principal;
    double least = std::numeric_limits<double>::infinity();
    for (const int turns : {0, -1, 1, -2, 2}) {
      if (turns != 0 && principal.isZero()) break;
      const Vec3 candidate = addTurns(principal, turns, Vec3::UnitZ());
      double sum = 0, largest = 0;
      for (std::size_t i = 0; i < shares.size(); ++i) {
        const double apart = wanted[i].angularDistance(start * expQuaternion(shares[i] * candidate));
        sum += apart * apart, largest = std::max(largest, apart);
      }
      if (sum < least * (1 - 1e-9) - 1e-12) least = sum, best = candidate;
      if (turns == 0 && largest < surelyNearest) break;
    }
    return best;
  }

  // The last key repeats the first, moved rigidly, so the loop continues from the previous key.
  void closeOnFirstKey() {
    const int step = KeySteps{shape_.keys}.turnedClosing();
    const auto [from, to] = posesOf(shape_, step);
    const std::vector<Vec3>& alike = out_.increment[shape_.keys - 2];
    std::vector<Vec3>& closing = out_.increment[step];
    closing.assign(alike.size(), Vec3::Zero());
    for (std::size_t f = 0; f < closing.size(); ++f) {
      // Relative to a base frame, which rotates as well, no rotation is added.
      const Quaternion turned = root_ < 0 ? Quaternion(shape_.closing->rotation * out_.key[to][f]) : out_.key[to][f];
      closing[f] = nearestRepresentative(logRotation(Quaternion(out_.key[from][f].conjugate() * turned)), alike[f]);
    }
  }

  const WeldedShape& shape_;
  const LriSpace& lri_;
  int root_;
  RotationSplines out_;
};

}  // namespace

OwnPathsSpace::OwnPathsSpace(const WeldedKeys& keys, const LriSpace& lri, OwnPaths base) : keys_(&keys), base_(base) {
  const HoldInput frames = lri.holdInput();
  const std::vector<int> localFrameOf(frames.mesh.localFrameOf.begin(), frames.mesh.localFrameOf.end());
  root_ = largestFrame(keys.shape, localFrameOf, frames.rotation.front().size());
  const RotationSplines paths = PathFinder(keys.shape, lri, base == OwnPaths::Root ? root_ : -1).run();
  lri.withReconstructor([&]<class Real>(const Reconstructor<Real>& r) {
    std::vector<int> slotOf;
    for (int f = 0; f < keys.shape.faceCount(); ++f) slotOf.push_back(r.coordinates().face.slot(f));
    paths_ = RotationPaths<Real>(paths, KeySteps{keys.shape.keys}, slotOf);
  });
}

Quaternion OwnPathsSpace::baseAt(const CurvePoint& point, const LocalFrames& frames) const {
  if (base_ == OwnPaths::Root) return frames.rotation[root_];
  const std::optional<RigidMotion>& closing = keys_->shape.closing;
  if (!closing || point.closes) return Quaternion::Identity();
  return Quaternion(closing->power(point.basePeriod).rotation);
}

template <class Real>
void OwnPathsSpace::rotationsAt(const CurvePoint& point, const LocalFrames& frames,
                                const Reconstructor<Real>& reconstructor,
                                typename Reconstructor<Real>::Scratch& scratch, RotationBlocks<Real>& own,
                                RotationBlocks<Real>& rotations, ForkJoin* forkJoin) const {
  std::get<RotationPaths<Real>>(paths_).at(point, baseAt(point, frames), own, forkJoin);
  reconstructor.rotationsAt(point, frames, scratch, rotations, forkJoin);
  fadeRotations(own, rotations, forkJoin);
}

template void OwnPathsSpace::rotationsAt(const CurvePoint&, const LocalFrames&, const Reconstructor<float>&,
                                         Reconstructor<float>::Scratch&, RotationBlocks<float>&, RotationBlocks<float>&,
                                         ForkJoin*) const;
template void OwnPathsSpace::rotationsAt(const CurvePoint&, const LocalFrames&, const Reconstructor<double>&,
                                         Reconstructor<double>::Scratch&, RotationBlocks<double>&,
                                         RotationBlocks<double>&, ForkJoin*) const;

}  // namespace shapespline
