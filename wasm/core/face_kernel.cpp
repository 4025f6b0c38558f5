#include "core/face_kernel.h"

#include <bit>
#include <cmath>
#include <type_traits>

#include "core/face_frame.h"
#include "core/lanes.h"

namespace shapespline {

namespace {

// sin(a) / a and (1 - cos(a)) / a^2 as power series in x = a^2, up to x = seriesLimit (a little over half a turn). The
// first term left out is below the precision's rounding there; larger angles go through the C library. Most faces turn by
// less than half a radian against their frame: they take few terms.
constexpr double seriesLimit = 10.5, shortLimit = 0.25;
template <class Real>
constexpr int seriesTerms = std::is_same_v<Real, float> ? 11 : 17;
template <class Real>
constexpr int shortTerms = std::is_same_v<Real, float> ? 4 : 8;

struct Series {
  double sine[17], cosine[17];
};

constexpr Series makeSeries() {
  Series s{};
  double factorial = 1;  // (2k)! (2k + 1) in turn
  for (int k = 0; k < 17; ++k) {
    const double sign = k % 2 == 0 ? 1 : -1;
    if (k > 0) factorial *= (2.0 * k) * (2.0 * k + 1);  // (2k + 1)!
    s.sine[k] = sign / factorial;
    s.cosine[k] = sign / (factorial * (2.0 * k + 2));
  }
  return s;
}

constexpr Series series = makeSeries();

template <int terms, class Real>
Lanes<Real> horner(const double* coefficient, Lanes<Real> x) {
  auto sum = Lanes<Real>::splat(static_cast<Real>(coefficient[terms - 1]));
  for (int k = terms - 2; k >= 0; --k) sum = sum * x + Lanes<Real>::splat(static_cast<Real>(coefficient[k]));
  return sum;
}

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
  horner<seriesTerms<Real>, Real>(series.sine, squaredAngle).store(a);
  horner<seriesTerms<Real>, Real>(series.cosine, squaredAngle).store(b);
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
    return {horner<shortTerms<Real>, Real>(series.sine, squaredAngle), horner<shortTerms<Real>, Real>(series.cosine, squaredAngle)};
  if (!notPositive(L::splat(Real(seriesLimit)) - squaredAngle))
    return {horner<seriesTerms<Real>, Real>(series.sine, squaredAngle), horner<seriesTerms<Real>, Real>(series.cosine, squaredAngle)};
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

// exp(r) v with the factors of Rodrigues' formula.
template <class Real, class L = Lanes<Real>>
Vector3<L> rotate(const Rodrigues<Real>& f, const Vector3<L>& r, const Vector3<L>& v) {
  const Vector3<L> rv = cross(r, v), rrv = cross(r, rv);
  return {v.x + f.a * rv.x + f.b * rrv.x, v.y + f.a * rv.y + f.b * rrv.y, v.z + f.a * rv.z + f.b * rrv.z};
}

// exp of a symmetric 2x2 matrix in place, lane by lane.
template <class Real>
void exponentiate(Lanes<Real>& xx, Lanes<Real>& xy, Lanes<Real>& yy) {
  using L = Lanes<Real>;
  alignas(32) Real a[faceLanes], b[faceLanes], c[faceLanes];
  xx.store(a), xy.store(b), yy.store(c);
  for (int i = 0; i < faceLanes; ++i) {
    Mat2 m;
    m << static_cast<double>(a[i]), static_cast<double>(b[i]), static_cast<double>(b[i]), static_cast<double>(c[i]);
    m = expSymmetric(m);
    a[i] = static_cast<Real>(m(0, 0)), b[i] = static_cast<Real>(m(0, 1)), c[i] = static_cast<Real>(m(1, 1));
  }
  xx = L::load(a), xy = L::load(b), yy = L::load(c);
}

template <class Real>
int notPositiveDefinite(const Lanes<Real>& xx, const Lanes<Real>& xy, const Lanes<Real>& yy) {
  return std::popcount(static_cast<unsigned>(notPositive(xx * yy - xy * xy) | notPositive(xx + yy)));
}

// The six numbers of four faces at the given weights.
template <class Real>
void blend(const Real* block, const std::vector<Real>& weights, Lanes<Real> (&number)[numbersPerFace]) {
  using L = Lanes<Real>;
  for (L& n : number) n = L::zero();
  for (const Real weight : weights) {
    const L w = L::splat(weight);
    for (int k = 0; k < numbersPerFace; ++k, block += faceLanes) number[k] = number[k] + w * L::load(block);
  }
}

// Contributions of corners 0 and 1 (corner 2 has minus their sum) in the patches' frames: exp(r) [t1 t2] S g.
template <class Real>
struct Divergence {
  Vector3<Lanes<Real>> corner0, corner1;
};

template <class Real>
Divergence<Real> divergence(const FaceBlock<Real>& face, const Lanes<Real> (&n)[numbersPerFace]) {
  using L = Lanes<Real>;
  const Vector3<L> r{n[0], n[1], n[2]};
  const Rodrigues<Real> f = rodrigues<Real>(r.x * r.x + r.y * r.y + r.z * r.z);
  const L t1x = L::load(face.tangent[0]), t1y = L::load(face.tangent[1]), t1z = L::load(face.tangent[2]);
  const L t2x = L::load(face.tangent[3]), t2y = L::load(face.tangent[4]), t2z = L::load(face.tangent[5]);
  const auto corner = [&](const L& gx, const L& gy) {
    const L u = n[3] * gx + n[4] * gy, v = n[4] * gx + n[5] * gy;  // S g
    return rotate<Real>(f, r, Vector3<L>{t1x * u + t2x * v, t1y * u + t2y * v, t1z * u + t2z * v});
  };
  return {corner(L::load(face.gradient[0]), L::load(face.gradient[1])),
          corner(L::load(face.gradient[2]), L::load(face.gradient[3]))};
}

// Turns one lane's contributions by its frame and adds them to its three corners.
template <class Real>
void scatter(const FaceBlock<Real>& face, int lane, const Real* frames, const Real (&v)[6][faceLanes], Real* rhs) {
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

template <class Real>
void store(const Divergence<Real>& d, Real (&v)[6][faceLanes]) {
  d.corner0.x.store(v[0]), d.corner0.y.store(v[1]), d.corner0.z.store(v[2]);
  d.corner1.x.store(v[3]), d.corner1.y.store(v[4]), d.corner1.z.store(v[5]);
}

}  // namespace

template <class Real>
void FaceKernel<Real>::build(const WeldedShape& shape, const std::vector<int>& frameOf, Stretch stretch,
                             const std::vector<int>& order, const std::vector<int>& position, int dump,
                             const FractionReport& onProgress) {
  stretch_ = stretch;
  blocks_.assign((order.size() + faceLanes - 1) / faceLanes, {});
  const Positions& p = shape.poses[shape.reference];
  for (std::size_t i = 0; i < blocks_.size() * faceLanes; ++i) {
    reportItem(onProgress, i, order.size());
    FaceBlock<Real>& block = blocks_[i / faceLanes];
    const int lane = static_cast<int>(i % faceLanes);
    for (int c = 0; c < 3; ++c) block.corner[c][lane] = dump;
    if (i >= order.size() || frameOf[order[i]] < 0) continue;  // zero gradients contribute nothing
    const Triangle& t = shape.faces[order[i]];
    const FaceFrame frame = faceFrame(p[t[0]], p[t[1]], p[t[2]]);
    for (int k = 0; k < 3; ++k) {
      block.tangent[k][lane] = static_cast<Real>(frame.basis(k, 0));
      block.tangent[3 + k][lane] = static_cast<Real>(frame.basis(k, 1));
      block.corner[k][lane] = position[t[k]];
    }
    // area times gradient of a corner's hat function = half the opposite edge, turned by a quarter
    const Vec2 a = Vec2::Zero(), b = frame.edges.col(0), c = frame.edges.col(1);
    const auto quarter = [](const Vec2& e) { return Vec2(-e.y() / 2, e.x() / 2); };
    const Vec2 g0 = quarter(c - b), g1 = quarter(a - c);
    block.gradient[0][lane] = static_cast<Real>(g0.x());
    block.gradient[1][lane] = static_cast<Real>(g0.y());
    block.gradient[2][lane] = static_cast<Real>(g1.x());
    block.gradient[3][lane] = static_cast<Real>(g1.y());
    block.frame[lane] = frameOf[order[i]];
  }
}

template <class Real>
int FaceKernel<Real>::accumulate(const FaceCoordinates<Real>& coordinates, const std::vector<Real>& frames,
                                 const std::vector<Real>& weights, Real* rhs) const {
  int lost = 0;
  for (std::size_t b = 0; b < blocks_.size(); ++b) {
    Lanes<Real> number[numbersPerFace];
    blend(coordinates.block(static_cast<int>(b)), weights, number);
    if (stretch_ == Stretch::Log) exponentiate<Real>(number[3], number[4], number[5]);
    else lost += notPositiveDefinite<Real>(number[3], number[4], number[5]);
    alignas(32) Real v[6][faceLanes];
    store(divergence(blocks_[b], number), v);
    for (int lane = 0; lane < faceLanes; ++lane) scatter(blocks_[b], lane, frames.data(), v, rhs);
  }
  return lost;
}

template <class Real>
void FaceKernel<Real>::accumulateShift(const FaceCoordinates<Real>& coordinates, const std::vector<Real>& frames,
                                       const std::vector<Real>& weights, int face, const Vec3& difference, Real* rhs) const {
  const int slot = coordinates.slot(face);
  const FaceBlock<Real>& block = blocks_[slot / faceLanes];
  Lanes<Real> number[numbersPerFace];
  blend(coordinates.block(slot / faceLanes), weights, number);
  if (stretch_ == Stretch::Log) exponentiate<Real>(number[3], number[4], number[5]);
  alignas(32) Real v[6][faceLanes];
  store(divergence(block, number), v);
  for (auto& row : v) row[slot % faceLanes] = -row[slot % faceLanes];
  scatter(block, slot % faceLanes, frames.data(), v, rhs);
  for (int k = 0; k < 3; ++k) number[k] = number[k] + Lanes<Real>::splat(static_cast<Real>(difference[k]));
  store(divergence(block, number), v);
  scatter(block, slot % faceLanes, frames.data(), v, rhs);
}

template class FaceKernel<float>;
template class FaceKernel<double>;

}  // namespace shapespline
