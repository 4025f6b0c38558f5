#include "samples/limb.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include <Eigen/Geometry>

namespace shapespline {
namespace {

constexpr int samplesPerSpan = 64;  // of the curve, before it is resampled by arc length

Knot mirrored(const Knot& end, const Knot& next) { return {2 * end.centre - next.centre, end.radius}; }

double catmullRom(double a, double b, double c, double d, double t) {
  return b + 0.5 * t * (c - a + t * (2 * a - 5 * b + 4 * c - d + t * (3 * (b - c) + d - a)));
}

Knot catmullRom(const Knot& a, const Knot& b, const Knot& c, const Knot& d, double t) {
  Knot result;
  for (int k = 0; k < 3; ++k) result.centre[k] = catmullRom(a.centre[k], b.centre[k], c.centre[k], d.centre[k], t);
  result.radius = catmullRom(a.radius, b.radius, c.radius, d.radius, t);
  return result;
}

std::vector<Knot> sampleCurve(std::vector<Knot> knots) {
  knots.insert(knots.begin(), mirrored(knots[0], knots[1]));
  knots.push_back(mirrored(knots[knots.size() - 1], knots[knots.size() - 2]));
  std::vector<Knot> samples;
  for (std::size_t i = 1; i + 2 < knots.size(); ++i) {
    for (int k = 0; k < samplesPerSpan; ++k) {
      samples.push_back(catmullRom(knots[i - 1], knots[i], knots[i + 1], knots[i + 2], double(k) / samplesPerSpan));
    }
  }
  samples.push_back(knots[knots.size() - 2]);
  return samples;
}

void resample(const std::vector<Knot>& curve, int joints, Limb& limb) {
  std::vector<double> length{0};
  for (std::size_t i = 1; i < curve.size(); ++i) {
    length.push_back(length.back() + (curve[i].centre - curve[i - 1].centre).norm());
  }
  std::size_t span = 0;
  for (int j = 0; j < joints; ++j) {
    const double wanted = length.back() * j / (joints - 1);
    while (span + 2 < curve.size() && length[span + 1] < wanted) ++span;
    const double t = std::clamp((wanted - length[span]) / (length[span + 1] - length[span]), 0.0, 1.0);
    limb.centre.push_back((1 - t) * curve[span].centre + t * curve[span + 1].centre);
    limb.radius.push_back((1 - t) * curve[span].radius + t * curve[span + 1].radius);
  }
}

Vec3 tangentAt(const Positions& line, int i) {
  const int last = static_cast<int>(line.size()) - 1;
  return (line[std::min(i + 1, last)] - line[std::max(i - 1, 0)]).normalized();
}

void transportFrames(Limb& limb) {
  Vec3 tangent = tangentAt(limb.centre, 0);
  Vec3 side = tangent.cross(std::abs(tangent.z()) < 0.9 ? Vec3::UnitZ() : Vec3::UnitX()).normalized();
  for (int i = 0; i < limb.jointCount(); ++i) {
    const Vec3 next = tangentAt(limb.centre, i);
    side = Eigen::Quaterniond::FromTwoVectors(tangent, next) * side;
    side = (side - side.dot(next) * next).normalized();
    tangent = next;
    Mat3 frame;
    frame << side, tangent.cross(side), tangent;
    limb.frame.push_back(frame);
  }
}

// Grooves meet at the tip, so they fade where the offset points along the limb.
double ribFactor(const Limb& limb, double along, const Vec3& offset, double distance) {
  if (limb.ribs.count == 0 || distance <= 0) return 1;
  const Vec3 local = limb.frame[std::lround(along)].transpose() * offset;
  const double across = std::hypot(local.x(), local.y()) / distance;
  const double crest = std::cos(0.5 * limb.ribs.count * std::atan2(local.y(), local.x()));
  const double rounded = std::sqrt(crest * crest + 0.04) - 0.2;
  return 1 - limb.ribs.depth * across * across * (1 - rounded);
}

double flattenedLength(const Flattening& flattening, const Vec3& offset) {
  if (flattening.factor == 1) return offset.norm();
  const double along = flattening.direction.dot(offset);
  return (offset + (1 / flattening.factor - 1) * along * flattening.direction).norm();
}

struct SpanPoint {
  double t, length, distance;  // along the span, from the centre line, from the surface without ribs
  Vec3 offset;
};

SpanPoint nearestOnSpan(const Limb& limb, int span, const Vec3& point) {
  const Vec3& start = limb.centre[span];
  const Vec3 axis = limb.centre[span + 1] - start;
  SpanPoint result;
  result.t = std::clamp((point - start).dot(axis) / axis.squaredNorm(), 0.0, 1.0);
  result.offset = point - start - result.t * axis;
  result.length = flattenedLength(limb.flattening, result.offset);
  result.distance = result.length - (1 - result.t) * limb.radius[span] - result.t * limb.radius[span + 1];
  return result;
}

void enclose(Limb& limb) {
  for (int first = 0; first + 1 < limb.jointCount(); first += Bound::spans) {
    const int last = std::min(first + Bound::spans, limb.jointCount() - 1);
    Bound bound{0.5 * (limb.centre[first] + limb.centre[last]), 0};
    for (int i = first; i <= last; ++i) {
      bound.radius = std::max(bound.radius, (limb.centre[i] - bound.middle).norm() + limb.radius[i]);
    }
    limb.bounds.push_back(bound);
  }
}

}  // namespace

int Body::jointCount() const { return firstJoint(static_cast<int>(limbs.size())); }

int Body::firstJoint(int limb) const {
  int first = 0;
  for (int i = 0; i < limb; ++i) first += limbs[i].jointCount();
  return first;
}

Limb makeLimb(const std::vector<Knot>& knots, int joints) {
  Limb limb;
  resample(sampleCurve(knots), joints, limb);
  transportFrames(limb);
  enclose(limb);
  return limb;
}

Limb makeLimb(const std::vector<Knot>& knots, int joints, double edge, double blend) {
  Limb limb = makeLimb(knots, joints);
  limb.edge = edge;
  limb.blend = blend;
  return limb;
}

int attach(Body& body, int parent, Limb limb) {
  limb.parent = parent;
  if (parent >= 0) {
    const Positions& line = body.limbs[parent].centre;
    const Vec3 root = limb.centre.front();
    const auto nearest = std::min_element(line.begin(), line.end(), [&](const Vec3& a, const Vec3& b) {
      return (a - root).squaredNorm() < (b - root).squaredNorm();
    });
    limb.parentJoint = static_cast<int>(nearest - line.begin());
  }
  body.limbs.push_back(std::move(limb));
  return static_cast<int>(body.limbs.size()) - 1;
}

double wantedEdge(const Limb& limb, int joint) { return std::min(limb.edge, 2 * M_PI / 11 * limb.radius[joint]); }

LimbPoint nearestOnLimb(const Limb& limb, const Vec3& point, double limit) {
  limit /= limb.flattening.factor;
  int best = -1;
  SpanPoint at;
  for (int group = 0; group < static_cast<int>(limb.bounds.size()); ++group) {
    const Bound& bound = limb.bounds[group];
    if ((point - bound.middle).norm() - bound.radius >= limit) continue;
    const int first = group * Bound::spans, end = std::min(first + Bound::spans, limb.jointCount() - 1);
    for (int span = first; span < end; ++span) {
      const SpanPoint candidate = nearestOnSpan(limb, span, point);
      if (candidate.distance >= limit) continue;
      limit = candidate.distance;
      at = candidate;
      best = span;
    }
  }
  if (best < 0) return {0, limit * limb.flattening.factor};
  const double along = best + at.t, radius = at.length - at.distance;
  const double surface = radius * ribFactor(limb, along, at.offset, at.length);
  return {along, (at.length - surface) * limb.flattening.factor};
}

}  // namespace shapespline
