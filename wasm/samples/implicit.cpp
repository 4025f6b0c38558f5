#include "samples/implicit.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace shapespline {
namespace {

// The quadratic smooth minimum: differs from min(a, b) only where |a - b| < width, by at most width / 4.
double smoothMin(double a, double b, double width) {
  if (width <= 0) return std::min(a, b);
  const double h = std::max(width - std::abs(a - b), 0.0);
  return std::min(a, b) - h * h / (4 * width);
}

// Value and gradient from the corners of a small tetrahedron around the point.
struct Linear {
  double value;
  Vec3 gradient;
};

Linear linearise(const Field& field, const Vec3& point, double step) {
  Linear result{0, Vec3::Zero()};
  for (const Vec3& corner : {Vec3(1, 1, 1), Vec3(1, -1, -1), Vec3(-1, 1, -1), Vec3(-1, -1, 1)}) {
    const double value = field(point + step * corner);
    result.value += value / 4;
    result.gradient += value / (4 * step) * corner;
  }
  return result;
}

}  // namespace

double fieldValue(const Body& body, const Vec3& point) {
  double value = std::numeric_limits<double>::max();
  for (const Limb& limb : body.limbs) {
    // Further away than this it cannot change the minimum.
    const double limit = value + limb.blend;
    value = smoothMin(value, nearestOnLimb(limb, point, limit).distance, limb.blend);
  }
  return body.floor ? -smoothMin(-value, point.y() - *body.floor, body.floorRounding) : value;
}

BodyPoint nearestOnBody(const Body& body, const Vec3& point) {
  BodyPoint best;
  best.on.distance = std::numeric_limits<double>::max();
  for (int i = 0; i < static_cast<int>(body.limbs.size()); ++i) {
    const LimbPoint on = nearestOnLimb(body.limbs[i], point, best.on.distance);
    if (on.distance < best.on.distance) best = {i, on};
  }
  return best;
}

double wantedEdge(const Body& body, const Vec3& point) {
  double edge = std::numeric_limits<double>::max();
  for (const Limb& limb : body.limbs) {
    const double limit = 2 * edge;
    const LimbPoint nearest = nearestOnLimb(limb, point, limit);
    if (nearest.distance >= limit) continue;
    const double own = wantedEdge(limb, static_cast<int>(std::lround(nearest.along)));
    edge = std::min(edge, own + 0.5 * std::max(nearest.distance, 0.0));
  }
  return edge;
}

Vec3 projectToSurface(const Field& field, Vec3 point, double step) {
  for (int i = 0; i < 2; ++i) {
    const auto [value, gradient] = linearise(field, point, step);
    point -= std::clamp(value, -10 * step, 10 * step) * gradient / std::max(gradient.squaredNorm(), 0.1);
  }
  return point;
}

}  // namespace shapespline
