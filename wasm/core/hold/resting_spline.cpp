#include "core/hold/resting_spline.h"

#include <algorithm>
#include <cmath>

#include "core/hold/hold_passes.h"
#include "core/hold/hold_system.h"

namespace shapespline {

namespace {

// A vertex rests in a span if it moves less than .03 of its motion in a neighbouring span. From .10 on, it does not
// rest.
constexpr double atRest = 0.03, inMotion = 0.10;
constexpr double minMotion = 1e-4;  // share of the size
// Cosine of the angle from which a vertex counts as reversing, and the range of the speed ratio of both sides.
constexpr double backwards = 0.5, dawdles = 0.1, hurries = 0.3;

RigidMotion motionOf(const WeldedShape& shape, int periods) {
  return shape.closing && periods != 0 ? shape.closing->power(periods) : RigidMotion{};
}

// xyz of each vertex. Omits weights too small for any sum.
std::vector<float> slopesAt(const WeldedShape& shape, const Curve& curve, double t) {
  constexpr double least = 1e-9;
  const Columns columns{shape.keys};
  Positions sum(shape.poses[0].size(), Vec3::Zero());
  const std::vector<KeyWeight> weights = curve.slopeAt(t);
  double largest = 0;
  for (const KeyWeight& w : weights) largest = std::max(largest, std::abs(w.weight));
  for (const KeyWeight& w : weights) {
    if (std::abs(w.weight) < least * largest) continue;
    const int pose = w.key == columns.startTangent() ? shape.startTangent
                     : w.key == columns.endTangent() ? shape.endTangent
                                                     : w.key;
    const RigidMotion motion = motionOf(shape, curve.closesOnLastKey() ? w.period : 0);
    const Mat3 turn = w.weight * motion.rotation.toRotationMatrix();
    const Vec3 move = w.weight * motion.translation;
    for (std::size_t v = 0; v < sum.size(); ++v) sum[v] += turn * shape.poses[pose][v] + move;
  }
  std::vector<float> result(3 * sum.size());
  for (std::size_t i = 0; i < result.size(); ++i) result[i] = static_cast<float>(sum[i / 3][i % 3]);
  return result;
}

}  // namespace

double keySize(const WeldedShape& shape) {
  double size = 0;
  for (int key = 0; key < shape.keys; ++key) size = std::max(size, sizeOf(shape.poses[key]));
  return size;
}

RestingSpline::RestingSpline(const WeldedShape& shape, const Curve& curve, const PathRest& rest)
    : spans_(curve.spans()), loop_(curve.periodic()) {
  for (const KeySpan& span : spans_) knots_.push_back(&shape.poses[span.from]);
  knots_.push_back(&shape.poses[spans_.back().to]);
  if (curve.closesOnLastKey()) {
    closed_ = shape.poses[0];
    const RigidMotion closing = motionOf(shape, 1);
    for (Vec3& p : closed_) p = closing(p);
    knots_.back() = &closed_;
  }
  for (const KeySpan& span : spans_) slope_.push_back(slopesAt(shape, curve, span.start));
  slope_.push_back(slopesAt(shape, curve, spans_.back().end));
  rest_.assign(spans_.size(), std::vector<float>(shape.poses[0].size()));
  knotRest_.assign(knots_.size(), std::vector<float>(shape.poses[0].size()));
  if (rest.where == PathRest::WhereStill) findRest(rest.size);
  if (rest.where == PathRest::AtEnds && !loop_)
    for (std::vector<float>* end : {&knotRest_.front(), &knotRest_.back()}) std::fill(end->begin(), end->end(), 1.0f);
}

void RestingSpline::findRest(double size) {
  const int count = spans();
  const std::size_t vertices = knots_[0]->size();
  const double meanTime = (spans_.back().end - spans_.front().start) / count;
  std::vector<double> moved(count);
  const auto neighbour = [&](int span) { return loop_ ? (span + count) % count : span; };
  for (std::size_t v = 0; v < vertices; ++v) {
    for (int s = 0; s < count; ++s)
      moved[s] = ((*knots_[s + 1])[v] - (*knots_[s])[v]).norm() * meanTime / (spans_[s].end - spans_[s].start);
    const auto movedIn = [&](int span) { return span >= 0 && span < count ? moved[span] : 0; };
    for (int s = 0; s < count; ++s) {
      const double around = std::max(movedIn(neighbour(s - 1)), movedIn(neighbour(s + 1)));
      rest_[s][v] =
          static_cast<float>((1 - smoothstep2(moved[s] / (around + minMotion * size), atRest, inMotion)) *
                             (1 - turnsBack(v, neighbour(s - 1), neighbour(s + 1), minMotion * size / meanTime)));
    }
    const auto restIn = [&](int span) { return span >= 0 && span < count ? rest_[span][v] : 0; };
    for (int k = 0; k <= count; ++k)
      knotRest_[k][v] = std::max(restIn(loop_ ? neighbour(k - 1) : k - 1), restIn(loop_ ? neighbour(k) % count : k));
  }
}

// A swinging limb barely moves between two keys on either side of its turning point, but does not rest: it reverses at
// the same speed. Motions slower than `slowest` are ignored, because rounding determines their direction.
double RestingSpline::turnsBack(std::size_t v, int before, int after, double slowest) const {
  if (before < 0 || after < 0 || before >= spans() || after >= spans()) return 0;
  const auto speed = [&](int s) -> Vec3 {
    return ((*knots_[s + 1])[v] - (*knots_[s])[v]) / (spans_[s].end - spans_[s].start);
  };
  const Vec3 came = speed(before), goes = speed(after);
  const double slower = std::min(came.norm(), goes.norm()), faster = std::max(came.norm(), goes.norm());
  if (!(slower > 0)) return 0;
  return smoothstep2(-came.dot(goes) / (slower * faster + slowest * slowest), 0, backwards) *
         smoothstep2(slower / faster, dawdles, hurries);
}

bool RestingSpline::hasSpansOf(const RestingSpline& other) const {
  const auto same = [](const KeySpan& a, const KeySpan& b) {
    return a.start == b.start && a.end == b.end && a.from == b.from && a.to == b.to;
  };
  return loop_ == other.loop_ &&
         std::equal(spans_.begin(), spans_.end(), other.spans_.begin(), other.spans_.end(), same);
}

SpanPosition RestingSpline::spanPositionAt(double t) const {
  const auto after = std::upper_bound(spans_.begin(), spans_.end(), t,
                                      [](double time, const KeySpan& span) { return time < span.start; });
  SpanPosition inSpan;
  inSpan.span = std::max(0, static_cast<int>(after - spans_.begin()) - 1);
  const KeySpan& span = spans_[inSpan.span];
  const double share = (t - span.start) / (span.end - span.start);
  inSpan.share = std::clamp(share, 0.0, 1.0);
  inSpan.beyond = std::abs(share - inSpan.share);
  return inSpan;
}

void RestingSpline::positionsAt(double t, Positions& positions) const {
  const SpanPosition inSpan = spanPositionAt(t);
  const int k = inSpan.span;
  const double h = spans_[k].end - spans_[k].start, u = inSpan.share, w = 1 - u;
  PathWeights at;
  at.step = u * u * (3 - 2 * u);
  at.slope0 = h * u * w * w;
  at.slope1 = -h * u * u * w;
  // Quintics with only a velocity or only an acceleration at one end, to remove those of the cubic.
  const double velocity0 = u - u * u * u * (6 + u * (3 * u - 8)), velocity1 = u * u * u * (u * (7 - 3 * u) - 4);
  const double acceleration0 = u * u * w * w * w / 2, acceleration1 = u * u * u * w * w / 2;
  at.rest0[0] = 6 * acceleration0;
  at.rest0[1] = h * (velocity0 - 4 * acceleration0);
  at.rest0[2] = -2 * h * acceleration0;
  at.rest1[0] = -6 * acceleration1;
  at.rest1[1] = 2 * h * acceleration1;
  at.rest1[2] = h * (velocity1 + 4 * acceleration1);
  if (inSpan.beyond > 0) {  // continues straight from the end, with the velocity reduced by rest
    const double further = h * (u > 0 ? inSpan.beyond : -inSpan.beyond);
    (u > 0 ? at.slope1 : at.slope0) += further;
    if (u > 0) at.rest1[2] += further;
    else at.rest0[1] += further;
  }
  const std::size_t from = k, to = from + 1;
  pathPositions({*knots_[from], slope_[from], knotRest_[from]}, {*knots_[to], slope_[to], knotRest_[to]}, at,
                positions);
}

}  // namespace shapespline
