#include "core/hold/vertex_path.h"

#include <algorithm>
#include <cmath>

namespace shapespline {

namespace {

// A vertex rests in a span where it moves less than .03 of what it moves in a neighbouring one, and not from .10 on.
constexpr double atRest = 0.03, inMotion = 0.10;
constexpr double leastMotion = 1e-4;  // of the diagonal

// A slope as a combination of the poses: sum of turn * pose, and a move.
struct Slope {
  std::vector<Mat3> turn;  // of each pose
  Vec3 move = Vec3::Zero();
};

Slope slopeOf(const WeldedShape& shape, const Curve& curve, double t) {
  const Columns columns{shape.keys};
  Slope slope{std::vector<Mat3>(shape.columns(), Mat3::Zero()), Vec3::Zero()};
  for (const KeyWeight& w : curve.slopeAt(t)) {
    const int pose = w.key == columns.startTangent() ? shape.startTangent
                     : w.key == columns.endTangent() ? shape.endTangent
                                                     : w.key;
    if (w.period == 0 || !curve.closesOnLastKey()) {
      slope.turn[pose] += w.weight * Mat3::Identity();
      continue;
    }
    const RigidMotion motion = shape.closing->power(w.period);
    slope.turn[pose] += w.weight * motion.rotation.toRotationMatrix();
    slope.move += w.weight * motion.translation;
  }
  return slope;
}

std::vector<float> slopesOf(const WeldedShape& shape, const Slope& slope) {
  std::vector<float> result;
  result.reserve(3 * static_cast<std::size_t>(shape.vertexCount()));
  for (std::size_t v = 0; v < shape.poses[0].size(); ++v) {
    Vec3 sum = slope.move;
    for (std::size_t pose = 0; pose < slope.turn.size(); ++pose)
      if (!slope.turn[pose].isZero(0)) sum += slope.turn[pose] * shape.poses[pose][v];
    for (const double x : sum) result.push_back(static_cast<float>(x));
  }
  return result;
}

double knotTime(const std::vector<KeySpan>& spans, std::size_t knot) {
  return knot < spans.size() ? spans[knot].start : spans.back().end;
}

}  // namespace

VertexPath::VertexPath(const WeldedShape& shape, const Curve& curve) : spans_(curve.spans()), loop_(curve.periodic()) {
  for (const KeySpan& span : spans_) knots_.push_back(&shape.poses[span.from]);
  knots_.push_back(&shape.poses[spans_.back().to]);
  if (curve.closesOnLastKey()) {
    Positions closed = shape.poses[0];
    for (Vec3& p : closed) p = (*shape.closing)(p);
    own_.push_back(std::move(closed));
    knots_.back() = &own_.back();
  }
  for (std::size_t k = 0; k < knots_.size(); ++k)
    slope_.push_back(slopesOf(shape, slopeOf(shape, curve, knotTime(spans_, k))));
  findRest(boundingDiagonal(knots_));
}

VertexPath::VertexPath(const WeldedShape& shape, const Curve& curve, const std::vector<Mat3>& rotation,
                       const std::vector<Vec3>& origin)
    : spans_(curve.spans()), loop_(curve.periodic()) {
  WeldedShape body = shape;
  body.closing.reset();
  for (int pose = 0; pose < shape.columns(); ++pose)
    for (Vec3& p : body.poses[pose]) p = rotation[pose].transpose() * (p - origin[pose]);
  for (std::size_t k = 0; k < spans_.size() + 1; ++k) {
    Slope slope{std::vector<Mat3>(shape.columns(), Mat3::Zero()), Vec3::Zero()};
    const Columns columns{shape.keys};
    for (const KeyWeight& w : curve.slopeAt(knotTime(spans_, k)))
      slope.turn[w.key == columns.startTangent() ? shape.startTangent
                 : w.key == columns.endTangent() ? shape.endTangent
                                                 : w.key] += w.weight * Mat3::Identity();
    slope_.push_back(slopesOf(body, slope));
  }
  own_ = std::move(body.poses);
  for (const KeySpan& span : spans_) knots_.push_back(&own_[span.from]);
  knots_.push_back(&own_[curve.closesOnLastKey() ? 0 : spans_.back().to]);
  knotRest_.resize(knots_.size());
}

void VertexPath::findRest(double diagonal) {
  const int count = spans();
  const std::size_t vertices = knots_[0]->size();
  const double meanTime = (spans_.back().end - spans_.front().start) / count;
  std::vector<double> moved(count);
  rest_.assign(count, std::vector<float>(vertices));
  knotRest_.assign(knots_.size(), std::vector<float>(vertices));
  const auto neighbour = [&](int span) { return loop_ ? (span + count) % count : span; };
  for (std::size_t v = 0; v < vertices; ++v) {
    for (int s = 0; s < count; ++s)
      moved[s] = ((*knots_[s + 1])[v] - (*knots_[s])[v]).norm() * meanTime / (spans_[s].end - spans_[s].start);
    const auto movedIn = [&](int span) { return span >= 0 && span < count ? moved[span] : 0; };
    for (int s = 0; s < count; ++s) {
      const double around = std::max(movedIn(neighbour(s - 1)), movedIn(neighbour(s + 1)));
      rest_[s][v] = static_cast<float>(1 - fade(moved[s] / (around + leastMotion * diagonal), atRest, inMotion));
    }
    const auto restIn = [&](int span) { return span >= 0 && span < count ? rest_[span][v] : 0; };
    for (int k = 0; k <= count; ++k)
      knotRest_[k][v] = std::max(restIn(loop_ ? neighbour(k - 1) : k - 1), restIn(loop_ ? neighbour(k) % count : k));
  }
}

SpanPlace VertexPath::placeOf(double t) const {
  const auto after = std::upper_bound(spans_.begin(), spans_.end(), t,
                                      [](double time, const KeySpan& span) { return time < span.start; });
  SpanPlace place;
  place.span = std::max(0, static_cast<int>(after - spans_.begin()) - 1);
  const KeySpan& span = spans_[place.span];
  const double share = (t - span.start) / (span.end - span.start);
  place.share = std::clamp(share, 0.0, 1.0);
  place.beyond = std::abs(share - place.share);
  return place;
}

VertexPath::At VertexPath::at(double t) const {
  const SpanPlace place = placeOf(t);
  const int k = place.span;
  const double h = spans_[k].end - spans_[k].start, u = place.share, w = 1 - u;
  At at{knots_[k], knots_[k + 1], &slope_[k], &slope_[k + 1], &knotRest_[k], &knotRest_[k + 1]};
  at.step = u * u * (3 - 2 * u);
  at.slope0 = h * u * w * w;
  at.slope1 = -h * u * u * w;
  // Velocity and acceleration of the cubic at its ends, times the quintics that have nothing else there.
  const double velocity0 = u - u * u * u * (6 + u * (3 * u - 8)), velocity1 = u * u * u * (u * (7 - 3 * u) - 4);
  const double acceleration0 = u * u * w * w * w / 2, acceleration1 = u * u * u * w * w / 2;
  at.rest0[0] = 6 * acceleration0;
  at.rest0[1] = h * (velocity0 - 4 * acceleration0);
  at.rest0[2] = -2 * h * acceleration0;
  at.rest1[0] = -6 * acceleration1;
  at.rest1[1] = 2 * h * acceleration1;
  at.rest1[2] = h * (velocity1 + 4 * acceleration1);
  if (place.beyond > 0) {  // straight on from the end, with what rest leaves of its velocity
    const double further = h * (u > 0 ? place.beyond : -place.beyond);
    (u > 0 ? at.slope1 : at.slope0) += further;
    if (u > 0) at.rest1[2] += further;
    else at.rest0[1] += further;
  }
  return at;
}

}  // namespace shapespline
