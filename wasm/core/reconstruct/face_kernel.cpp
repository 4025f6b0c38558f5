#include "core/reconstruct/face_kernel.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <limits>
#include <utility>

#include "core/base/simd.h"
#include "core/lri/face_frame.h"
#include "core/reconstruct/rodrigues.h"
#include "core/reconstruct/stretch_limits.h"

namespace shapespline {

namespace {

template <class L>
struct Vector3 {
  L x, y, z;
};

template <class L>
Vector3<L> cross(const Vector3<L>& a, const Vector3<L>& b) {
  return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}

// One number for each face of a block.
template <class Real>
using Four = Real[faceLanes];

template <class Real>
Vector3<Lanes<Real>> load(const Four<Real>* v) {
  using L = Lanes<Real>;
  return {L::load(v[0]), L::load(v[1]), L::load(v[2])};
}

template <class Real>
void store(const Vector3<Lanes<Real>>& from, Four<Real>* v) {
  from.x.store(v[0]);
  from.y.store(v[1]);
  from.z.store(v[2]);
}

// Number of blocks per kernel step, and the data passed between steps. Each step is a short loop that fits the
// registers. A single loop would spill them and take twice the time.
constexpr int blocksAtOnce = 8;
template <class Real>
struct alignas(32) Passing {
  Four<Real> number[numbersPerFace];  // interpolated at the frame's weights
  Four<Real> factor[2];               // factors of Rodrigues' formula
  Four<Real> corner[6];  // contributions of corners 0 and 1 in the local frames; corner 2 gets minus their sum
};

template <class Real>
const Real* columnOf(const Real* block, int column) {
  return block + column * numbersPerFace * faceLanes;
}

// Three numbers of a column.
template <class Real>
Vector3<Lanes<Real>> loadThree(const Real* number) {
  using L = Lanes<Real>;
  return {L::load(number), L::load(number + faceLanes), L::load(number + 2 * faceLanes)};
}

// The six numbers, interpolated. lanes: a weight of every stored column for each face, then their values at rest.
template <class Real>
void blend(const Real* block, const std::vector<int>& stored, const Real* lanes, Passing<Real>& passing) {
  using L = Lanes<Real>;
  const L atRest = L::load(lanes + stored.size() * faceLanes);
  Vector3<L> r{L::zero(), L::zero(), L::zero()}, s{atRest, L::zero(), atRest};
  const auto add = [](L& sum, const L& w, const Real* number) { sum = sum + w * L::load(number); };
  for (std::size_t i = 0; i < stored.size(); ++i) {
    const L w = L::load(lanes + i * faceLanes);
    const Real* const column = columnOf(block, stored[i]);
    add(r.x, w, column);
    add(r.y, w, column + faceLanes);
    add(r.z, w, column + 2 * faceLanes);
    add(s.x, w, column + 3 * faceLanes);
    add(s.y, w, column + 4 * faceLanes);
    add(s.z, w, column + 5 * faceLanes);
  }
  store(r, passing.number);
  store(s, passing.number + 3);
}

// The weights of the four faces of a block. Most blocks lie in one part; others gather their weights in `mixed`.
template <class Real>
[[gnu::noinline]] const Real* lanesOfParts(const FaceBlock<Real>& face, const ColumnWeights<Real>& weights,
                                           std::vector<Real>& mixed) {
  int part[faceLanes];
  for (int i = 0; i < faceLanes; ++i) part[i] = weights.partOf[face.frame[i]];
  if (part[0] == part[1] && part[0] == part[2] && part[0] == part[3]) return weights.ofPart(part[0]);
  mixed.resize((weights.stored.size() + 1) * faceLanes);
  for (std::size_t i = 0; i < mixed.size(); ++i) mixed[i] = weights.ofPart(part[i % faceLanes])[i];
  return mixed.data();
}

// Symmetric 2x2 matrices, one per lane.
template <class L>
struct Symmetric {
  L xx, xy, yy;
};
template <class L>
Symmetric<L> operator-(const Symmetric<L>& m) {
  return {L::zero() - m.xx, L::zero() - m.xy, L::zero() - m.yy};
}

// Mean of the two eigenvalues, and their distance from it.
template <class L>
struct Eigenvalues {
  L mean, spread;
};
template <class L>
Eigenvalues<L> eigenvalues(const L& xx, const L& yy, const L& squaredXy) {
  const L half = L::splat(0.5), difference = (xx - yy) * half;
  return {(xx + yy) * half, squareRoot(difference * difference + squaredXy)};
}

// The largest u >= 0 for which u A + D is singular, or 0 if none exists: minus the least eigenvalue of A^-1 D. A is
// positive definite. With A = C C^T, this is the least eigenvalue of the symmetric C^-1 D C^-T, which avoids
// cancellation.
template <class L>
L nearness(const Symmetric<L>& a, const Symmetric<L>& d) {
  const L p = L::splat(1) / a.xx, s = a.xy * p, q = L::splat(1) / (a.yy - s * a.xy);
  const L xy = d.xy - s * d.xx;
  const auto [mean, spread] = eigenvalues(p * d.xx, q * (d.yy - s * (d.xy + xy)), (p * xy) * (q * xy));
  return larger(spread - mean, L::zero());
}

// Smallest and largest eigenvalue of the face's stretch, or of its logarithm, over the keys.
template <class L>
struct Extremes {
  L low, high;
};
template <class Real>
Extremes<Lanes<Real>> extremesOfKeys(const EndKey& end, const Real* block, Real rest) {
  using L = Lanes<Real>;
  constexpr Real most = std::numeric_limits<Real>::max();
  Extremes<L> result{L::splat(end.anyAtRest ? rest : most), L::splat(end.anyAtRest ? rest : -most)};
  for (int column = 0; column < end.storedKeys; ++column) {
    const auto [xx, xy, yy] = loadThree(columnOf(block, column) + 3 * faceLanes);
    const auto [mean, spread] = eigenvalues(xx, yy, xy * xy);
    result.low = smaller(result.low, mean - spread);
    result.high = larger(result.high, mean + spread);
  }
  return result;
}

// Evaluates beyond the keys. `passing` holds the change from the end key, which is linear in time. Its stretch is
// scaled to ease towards the limits (stretch_limits.h), and the end key is added. A logarithm has two limits. S_f has
// the lower one, and stays definite before it. The nearer limit does not depend on time.
template <class Real>
void goOnFrom(const EndKey& end, const Real* block, Stretch stretch, Passing<Real>& passing) {
  using L = Lanes<Real>;
  const bool isLog = stretch == Stretch::Log;
  const Real rest = isLog ? 0 : 1;
  const auto [low, high] = extremesOfKeys(end, block, rest);
  Vector3<L> r{L::zero(), L::zero(), L::zero()}, s{L::splat(rest), L::zero(), L::splat(rest)};
  if (end.column >= 0) {
    r = loadThree(columnOf(block, end.column));
    s = loadThree(columnOf(block, end.column) + 3 * faceLanes);
  }
  const auto turn = load(passing.number), change = load(passing.number + 3);
  const Symmetric<L> d{change.x, change.y, change.z};

  const L margin = L::splat(static_cast<Real>(isLog ? std::log(stretchMargin) : 1 / stretchMargin));
  const L least = isLog ? low - margin : low * margin;
  // A nearly flat face in the end key would have no significant room above the limit, so the room is slightly enlarged.
  Symmetric<L> room{s.x - least, s.y, s.z - least};
  const L little = (room.xx + room.yy) * L::splat(64 * std::numeric_limits<Real>::epsilon());
  room.xx = room.xx + little;
  room.yy = room.yy + little;
  L u = nearness(room, d);
  if (isLog) u = larger(u, nearness(Symmetric<L>{high + margin - s.x, L::zero() - s.y, high + margin - s.z}, -d));
  const L f = easing(u);
  store({r.x + turn.x, r.y + turn.y, r.z + turn.z}, passing.number);
  store({s.x + f * d.xx, s.y + f * d.xy, s.z + f * d.yy}, passing.number + 3);
}

// Exponential of the symmetric 2x2 matrices, in place.
template <class Real>
void exponentiate(Passing<Real>& passing) {
  auto &xx = passing.number[3], &xy = passing.number[4], &yy = passing.number[5];
  for (int i = 0; i < faceLanes; ++i) {
    Mat2 m;
    m << static_cast<double>(xx[i]), static_cast<double>(xy[i]), static_cast<double>(xy[i]), static_cast<double>(yy[i]);
    m = expSymmetric(m);
    xx[i] = static_cast<Real>(m(0, 0));
    xy[i] = static_cast<Real>(m(0, 1));
    yy[i] = static_cast<Real>(m(1, 1));
  }
}

template <class Real>
unsigned notPositiveDefinite(const Passing<Real>& passing) {
  const auto [xx, xy, yy] = load(passing.number + 3);
  return static_cast<unsigned>(notPositive(xx * yy - xy * xy) | notPositive(xx + yy));
}

template <class Real>
void findFactors(Passing<Real>& passing) {
  const auto r = load(passing.number);
  const Rodrigues<Real> f = rodrigues<Real>(r.x * r.x + r.y * r.y + r.z * r.z);
  f.a.store(passing.factor[0]);
  f.b.store(passing.factor[1]);
}

// Uses the rotations of four faces as unit quaternions q instead of exp(r). Rodrigues' formula then has the vector of q
// and the factors 2 q.w and 2.
template <class Real>
void takeRotations(const Real* rotations, Passing<Real>& passing) {
  using L = Lanes<Real>;
  store(loadThree(rotations), passing.number);
  const L w = L::load(rotations + 3 * faceLanes);
  (w + w).store(passing.factor[0]);
  L::splat(2).store(passing.factor[1]);
}

// exp(r) [t1 t2] S g for corners 0 and 1.
template <class Real>
void diverge(const FaceBlock<Real>& face, Passing<Real>& passing) {
  using L = Lanes<Real>;
  const auto r = load(passing.number), s = load(passing.number + 3);
  const L a = L::load(passing.factor[0]), b = L::load(passing.factor[1]);
  const auto turned = [&](const L& u, const L& v, Four<Real>* out) {
    const Vector3<L> t1 = load(face.tangent), t2 = load(face.tangent + 3);
    const Vector3<L> p{t1.x * u + t2.x * v, t1.y * u + t2.y * v, t1.z * u + t2.z * v};
    const Vector3<L> rp = cross(r, p), rrp = cross(r, rp);
    store({p.x + a * rp.x + b * rrp.x, p.y + a * rp.y + b * rrp.y, p.z + a * rp.z + b * rrp.z}, out);
  };
  const auto [h, g0, g1] = load(face.gradient);
  const L u = s.x * h, v = s.y * h;
  turned(s.y * g0 - u, s.z * g0 - v, passing.corner);
  turned(u + s.y * g1, v + s.z * g1, passing.corner + 3);
}

// Rotates one lane's contributions by a frame's matrix and adds them to its three corners.
template <class Real>
void scatter(const FaceBlock<Real>& face, int lane, const Real* g, const Four<Real>* v, Real* rhs) {
  using L = Lanes<Real>;
  const L g0 = L::load(g), g1 = L::load(g + 4), g2 = L::load(g + 8);
  const auto turned = [&](int k) {
    return g0 * L::loadSplat(&v[k][lane]) + g1 * L::loadSplat(&v[k + 1][lane]) + g2 * L::loadSplat(&v[k + 2][lane]);
  };
  const auto at = [&](int c) { return rhs + 4 * static_cast<std::size_t>(face.corner[c][lane]); };
  const L b0 = turned(0), b1 = turned(3);
  (L::load(at(0)) + b0).store(at(0));
  (L::load(at(1)) + b1).store(at(1));
  (L::load(at(2)) - (b0 + b1)).store(at(2));
}

// Position of each face's corners, or the trashSlot for faces without a frame.
std::vector<Triangle> cornersOf(const WeldedShape& shape, const std::vector<int>& localFrameOf,
                                const std::vector<int>& position, int trashSlot, const FractionReport& onProgress) {
  std::vector<Triangle> corners(shape.faces.size(), {trashSlot, trashSlot, trashSlot});
  inBlocks(onProgress, corners.size(), [&](std::size_t begin, std::size_t end) {
    for (std::size_t f = begin; f < end; ++f)
      for (int c = 0; c < 3 && localFrameOf[f] >= 0; ++c) corners[f][c] = position[shape.faces[f][c]];
  });
  return corners;
}

}  // namespace

template <class Real>
FaceKernel<Real>::FaceKernel(const WeldedShape& shape, const ShapeTopology& topology,
                             const std::vector<int>& localFrameOf, Stretch stretch, const std::vector<int>& position,
                             int trashSlot, const FractionReport& onProgress)
    : stretch_(stretch) {
  const std::vector<Triangle> corners = cornersOf(shape, localFrameOf, position, trashSlot, partOf(onProgress, 0, 0.1));
  FaceOrder ordered = orderFaces(corners, trashSlot + 1, trashSlot, partOf(onProgress, 0.1, 0.4));
  order_ = std::move(ordered.order);
  const FractionReport onBlocks = partOf(onProgress, 0.4, 1);
  ranges_ = ordered.ranges;
  blocks_.assign((order_.size() + faceLanes - 1) / faceLanes, {});
  const Positions& p = shape.poses[shape.reference];
  for (std::size_t i = 0; i < blocks_.size() * faceLanes; ++i) {
    reportItem(onBlocks, i, order_.size());
    FaceBlock<Real>& block = blocks_[i / faceLanes];
    const int lane = static_cast<int>(i % faceLanes);
    for (int c = 0; c < 3; ++c) block.corner[c][lane] = trashSlot;
    if (i >= order_.size() || localFrameOf[order_[i]] < 0) continue;  // zero gradients contribute nothing
    const Triangle& t = shape.faces[order_[i]];
    const FaceFrame frame = faceFrame(p[t[0]], p[t[1]], p[t[2]]);
    for (int k = 0; k < 3; ++k) {
      block.tangent[k][lane] = static_cast<Real>(frame.basis(k, 0));
      block.tangent[3 + k][lane] = static_cast<Real>(frame.basis(k, 1));
      block.corner[k][lane] = corners[order_[i]][k];
    }
    const Vec2 b = frame.edges.col(0), c = frame.edges.col(1);
    const double whole = topology.whole(order_[i]);
    const Vec2 g0 = whole * hatGradient(c - b), g1 = whole * hatGradient(-c);
    block.gradient[0][lane] = static_cast<Real>(g1.x());  // -g0.x()
    block.gradient[1][lane] = static_cast<Real>(g0.y());
    block.gradient[2][lane] = static_cast<Real>(g1.y());
    block.frame[lane] = localFrameOf[order_[i]];
  }
}

template <class Real>
IndefiniteFaces FaceKernel<Real>::accumulate(const FaceCoordinates<Real>& coordinates, const FaceTurns<Real>& turns,
                                             const ColumnWeights<Real>& weights, Real* rhs, ForkJoin* forkJoin) const {
  IndefiniteFaces found[3];
  inTwo(forkJoin, [&](int half) { found[half] = accumulateRange(ranges_[half], coordinates, turns, weights, rhs); });
  found[2] = accumulateRange(ranges_[2], coordinates, turns, weights, rhs);
  IndefiniteFaces all;
  for (const IndefiniteFaces& part : found) {
    all.count += part.count;
    all.slot = std::max(all.slot, part.slot);
  }
  return all;
}

template <class Real>
IndefiniteFaces FaceKernel<Real>::accumulateRange(const FaceRange& range, const FaceCoordinates<Real>& coordinates,
                                                  const FaceTurns<Real>& turns, const ColumnWeights<Real>& weights,
                                                  Real* rhs) const {
  alignas(32) static constexpr Real still[numbersPerFrame] = {1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0};
  IndefiniteFaces found;
  const int end = (range.end + faceLanes - 1) / faceLanes;
  Passing<Real> passing[blocksAtOnce];
  std::vector<Real> mixed;
  for (int first = range.begin / faceLanes; first < end; first += blocksAtOnce) {
    const FaceBlock<Real>* const block = &blocks_[static_cast<std::size_t>(first)];
    const int count = std::min(blocksAtOnce, end - first);
    for (int i = 0; i < count; ++i)
      blend(coordinates.block(first + i), weights.stored,
            weights.partOf.empty() ? weights.lanes.data() : lanesOfParts(block[i], weights, mixed), passing[i]);
    if (weights.end)
      for (int i = 0; i < count; ++i) goOnFrom(*weights.end, coordinates.block(first + i), stretch_, passing[i]);
    for (int i = 0; i < count; ++i) {
      if (stretch_ == Stretch::Log) {
        exponentiate(passing[i]);
      } else if (const unsigned lanes = notPositiveDefinite(passing[i])) {
        found.count += std::popcount(lanes);
        found.slot = (first + i) * faceLanes + std::countr_zero(lanes);
      }
    }
    for (int i = 0; i < count; ++i) {
      if (turns.faces) takeRotations(turns.faces + rotationBlock * static_cast<std::size_t>(first + i), passing[i]);
      else findFactors(passing[i]);
    }
    for (int i = 0; i < count; ++i) diverge(block[i], passing[i]);
    // Interleaves faces: neighbouring faces share corners, and each would wait for the previous store.
    for (int lane = 0; lane < faceLanes; ++lane)
      for (int i = 0; i < count; ++i) {
        const std::size_t frame = numbersPerFrame * static_cast<std::size_t>(block[i].frame[lane]);
        scatter(block[i], lane, turns.faces ? still : turns.frames + frame, passing[i].corner, rhs);
      }
  }
  return found;
}

template <class Real>
void FaceKernel<Real>::stretches(const FaceCoordinates<Real>& coordinates, const ColumnWeights<Real>& weights,
                                 std::vector<Real>& stretch) const {
  stretch.resize(blocks_.size() * stretchBlock);
  Passing<Real> passing;
  for (std::size_t b = 0; b < blocks_.size(); ++b) {
    const Real* const block = coordinates.block(static_cast<int>(b));
    blend(block, weights.stored, weights.lanes.data(), passing);
    if (weights.end) goOnFrom(*weights.end, block, stretch_, passing);
    if (stretch_ == Stretch::Log) exponentiate(passing);
    std::copy_n(&passing.number[3][0], stretchBlock, &stretch[b * stretchBlock]);
  }
}

template class FaceKernel<float>;
template class FaceKernel<double>;

}  // namespace shapespline
