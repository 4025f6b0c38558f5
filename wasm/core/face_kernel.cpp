#include "core/face_kernel.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <type_traits>
#include <utility>

#include "core/face_frame.h"
#include "core/lanes.h"
#include "core/rotation_series.h"

namespace shapespline {

namespace {

// The series' terms up to x = seriesLimit (a little over half a turn). The first term left out is below the precision's rounding
// there; larger angles go through the C library. Most faces turn by less than half a radian against their frame: they take few
// terms.
constexpr double seriesLimit = 10.5, shortLimit = 0.25;
template <class Real>
constexpr int seriesTerms = std::is_same_v<Real, float> ? 11 : 17;
template <class Real>
constexpr int shortTerms = std::is_same_v<Real, float> ? 4 : 8;

// The two factors of Rodrigues' formula exp(r) = I + a [r] + b [r]^2.
template <class Real>
struct Rodrigues {
  Lanes<Real> a, b;
};

template <class Real>
Rodrigues<Real> rodriguesOfLargeAngles(Lanes<Real> squaredAngle) {
  using L = Lanes<Real>;
  alignas(32) Real x[faceLanes], a[faceLanes], b[faceLanes];
  squaredAngle.store(x);
  horner<seriesTerms<Real>>(rotationSeries.sine, squaredAngle).store(a);
  horner<seriesTerms<Real>>(rotationSeries.cosine, squaredAngle).store(b);
  for (int i = 0; i < faceLanes; ++i) {
    if (x[i] <= Real(seriesLimit)) continue;
    const double angle = std::sqrt(static_cast<double>(x[i]));
    a[i] = static_cast<Real>(std::sin(angle) / angle);
    b[i] = static_cast<Real>((1 - std::cos(angle)) / (angle * angle));
  }
  return {L::load(a), L::load(b)};
}

template <class Real>
Rodrigues<Real> rodrigues(Lanes<Real> squaredAngle) {
  using L = Lanes<Real>;
  if (!notPositive(L::splat(Real(shortLimit)) - squaredAngle))
    return {horner<shortTerms<Real>>(rotationSeries.sine, squaredAngle), horner<shortTerms<Real>>(rotationSeries.cosine, squaredAngle)};
  if (!notPositive(L::splat(Real(seriesLimit)) - squaredAngle))
    return {horner<seriesTerms<Real>>(rotationSeries.sine, squaredAngle), horner<seriesTerms<Real>>(rotationSeries.cosine, squaredAngle)};
  return rodriguesOfLargeAngles<Real>(squaredAngle);
}

template <class L>
struct Vector3 {
  L x, y, z;
};

template <class L>
Vector3<L> cross(const Vector3<L>& a, const Vector3<L>& b) {
  return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}

// One number of each of the faces side by side.
template <class Real>
using Four = Real[faceLanes];

template <class Real>
Vector3<Lanes<Real>> load(const Four<Real>* v) {
  using L = Lanes<Real>;
  return {L::load(v[0]), L::load(v[1]), L::load(v[2])};
}

template <class Real>
void store(const Vector3<Lanes<Real>>& from, Four<Real>* v) {
  from.x.store(v[0]), from.y.store(v[1]), from.z.store(v[2]);
}

// Blocks that go through the kernel's steps together, and what a block hands from step to step. Each step is a short loop
// whose numbers fit the registers; all in one would spill them, at twice the time.
constexpr int blocksAtOnce = 8;
template <class Real>
struct alignas(32) Passing {
  Four<Real> number[numbersPerFace];  // at the frame's weights
  Four<Real> factor[2];               // of Rodrigues' formula
  Four<Real> corner[6];               // contributions of corners 0 and 1 in the frames; corner 2 has minus their sum
};

// The six numbers at the given weights.
template <class Real>
void blend(const Real* block, const ColumnWeights<Real>& weights, Passing<Real>& passing) {
  using L = Lanes<Real>;
  const L atRest = L::splat(weights.atRest);
  Vector3<L> r{L::zero(), L::zero(), L::zero()}, s{atRest, L::zero(), atRest};
  const auto add = [](L& sum, const L& w, const Real* number) { sum = sum + w * L::load(number); };
  for (const Real weight : weights.stored) {
    const L w = L::splat(weight);
    add(r.x, w, block), add(r.y, w, block + faceLanes), add(r.z, w, block + 2 * faceLanes);
    add(s.x, w, block + 3 * faceLanes), add(s.y, w, block + 4 * faceLanes), add(s.z, w, block + 5 * faceLanes);
    block += numbersPerFace * faceLanes;
  }
  store(r, passing.number);
  store(s, passing.number + 3);
}

// exp of the symmetric 2x2 matrices in place.
template <class Real>
void exponentiate(Passing<Real>& passing) {
  auto &xx = passing.number[3], &xy = passing.number[4], &yy = passing.number[5];
  for (int i = 0; i < faceLanes; ++i) {
    Mat2 m;
    m << static_cast<double>(xx[i]), static_cast<double>(xy[i]), static_cast<double>(xy[i]), static_cast<double>(yy[i]);
    m = expSymmetric(m);
    xx[i] = static_cast<Real>(m(0, 0)), xy[i] = static_cast<Real>(m(0, 1)), yy[i] = static_cast<Real>(m(1, 1));
  }
}

template <class Real>
int notPositiveDefinite(const Passing<Real>& passing) {
  const auto [xx, xy, yy] = load(passing.number + 3);
  return std::popcount(static_cast<unsigned>(notPositive(xx * yy - xy * xy) | notPositive(xx + yy)));
}

template <class Real>
void findFactors(Passing<Real>& passing) {
  const auto r = load(passing.number);
  const Rodrigues<Real> f = rodrigues<Real>(r.x * r.x + r.y * r.y + r.z * r.z);
  f.a.store(passing.factor[0]), f.b.store(passing.factor[1]);
}

// exp(r) [t1 t2] S g of corners 0 and 1.
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

// Turns one lane's contributions by its frame and adds them to its three corners.
template <class Real>
void scatter(const FaceBlock<Real>& face, int lane, const Real* frames, const Four<Real>* v, Real* rhs) {
  using L = Lanes<Real>;
  const Real* g = frames + numbersPerFrame * static_cast<std::size_t>(face.frame[lane]);
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

// Where each face's corners lie; in the dump for faces that take no part.
std::vector<Triangle> cornersOf(const WeldedShape& shape, const std::vector<int>& frameOf, const std::vector<int>& position, int dump,
                                const FractionReport& onProgress) {
  std::vector<Triangle> corners(shape.faces.size(), {dump, dump, dump});
  inBlocks(onProgress, corners.size(), [&](std::size_t begin, std::size_t end) {
    for (std::size_t f = begin; f < end; ++f)
      for (int c = 0; c < 3 && frameOf[f] >= 0; ++c) corners[f][c] = position[shape.faces[f][c]];
  });
  return corners;
}

}  // namespace

template <class Real>
std::vector<int> FaceKernel<Real>::build(const WeldedShape& shape, const std::vector<int>& frameOf, Stretch stretch,
                                         const std::vector<int>& position, int dump, const FractionReport& onProgress) {
  const std::vector<Triangle> corners = cornersOf(shape, frameOf, position, dump, partOf(onProgress, 0, 0.1));
  FaceHalves halves = halveFaces(corners, dump + 1, dump, partOf(onProgress, 0.1, 0.4));
  const std::vector<int>& order = halves.order;
  const FractionReport onBlocks = partOf(onProgress, 0.4, 1);
  stretch_ = stretch;
  ranges_ = halves.ranges;
  blocks_.assign((order.size() + faceLanes - 1) / faceLanes, {});
  const Positions& p = shape.poses[shape.reference];
  for (std::size_t i = 0; i < blocks_.size() * faceLanes; ++i) {
    reportItem(onBlocks, i, order.size());
    FaceBlock<Real>& block = blocks_[i / faceLanes];
    const int lane = static_cast<int>(i % faceLanes);
    for (int c = 0; c < 3; ++c) block.corner[c][lane] = dump;
    if (i >= order.size() || frameOf[order[i]] < 0) continue;  // zero gradients contribute nothing
    const Triangle& t = shape.faces[order[i]];
    const FaceFrame frame = faceFrame(p[t[0]], p[t[1]], p[t[2]]);
    for (int k = 0; k < 3; ++k) {
      block.tangent[k][lane] = static_cast<Real>(frame.basis(k, 0));
      block.tangent[3 + k][lane] = static_cast<Real>(frame.basis(k, 1));
      block.corner[k][lane] = corners[order[i]][k];
    }
    // area times gradient of a corner's hat function = half the opposite edge, turned by a quarter
    const Vec2 a = Vec2::Zero(), b = frame.edges.col(0), c = frame.edges.col(1);
    const auto quarter = [](const Vec2& e) { return Vec2(-e.y() / 2, e.x() / 2); };
    const Vec2 g0 = quarter(c - b), g1 = quarter(a - c);
    block.gradient[0][lane] = static_cast<Real>(g1.x());  // -g0.x()
    block.gradient[1][lane] = static_cast<Real>(g0.y());
    block.gradient[2][lane] = static_cast<Real>(g1.y());
    block.frame[lane] = frameOf[order[i]];
  }
  return std::move(halves.order);
}

template <class Real>
int FaceKernel<Real>::accumulate(const FaceCoordinates<Real>& coordinates, const std::vector<Real>& frames,
                                 const ColumnWeights<Real>& weights, Real* rhs, Crew* crew) const {
  int lost[2];
  inTwo(crew, [&](int half) { lost[half] = accumulateRange(ranges_[half], coordinates, frames, weights, rhs); });
  return lost[0] + lost[1] + accumulateRange(ranges_[2], coordinates, frames, weights, rhs);
}

template <class Real>
int FaceKernel<Real>::accumulateRange(const FaceRange& range, const FaceCoordinates<Real>& coordinates,
                                      const std::vector<Real>& frames, const ColumnWeights<Real>& weights, Real* rhs) const {
  int lost = 0;
  const int end = (range.end + faceLanes - 1) / faceLanes;
  Passing<Real> passing[blocksAtOnce];
  for (int first = range.begin / faceLanes; first < end; first += blocksAtOnce) {
    const FaceBlock<Real>* const block = &blocks_[static_cast<std::size_t>(first)];
    const int count = std::min(blocksAtOnce, end - first);
    for (int i = 0; i < count; ++i) blend(coordinates.block(first + i), weights, passing[i]);
    for (int i = 0; i < count; ++i) {
      if (stretch_ == Stretch::Log) exponentiate(passing[i]);
      else lost += notPositiveDefinite(passing[i]);
    }
    for (int i = 0; i < count; ++i) findFactors(passing[i]);
    for (int i = 0; i < count; ++i) diverge(block[i], passing[i]);
    // Not face after face: neighbours share corners, and each would wait for the sum that the one before has just stored.
    for (int lane = 0; lane < faceLanes; ++lane)
      for (int i = 0; i < count; ++i) scatter(block[i], lane, frames.data(), passing[i].corner, rhs);
  }
  return lost;
}

template class FaceKernel<float>;
template class FaceKernel<double>;

}  // namespace shapespline
