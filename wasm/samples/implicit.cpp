#include "samples/implicit.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace shapespline {
namespace {

constexpr double floorRounding = 0.12;  // of the edge where a body stands on its floor

// The quadratic smooth minimum: differs from min(a, b) only where |a - b| < width, by at most width / 4.
double smoothMin(double a, double b, double width) {
  if (width <= 0) return std::min(a, b);
  const double h = std::max(width - std::abs(a - b), 0.0);
  return std::min(a, b) - h * h / (4 * width);
}

Vec3 gradient(const Field& field, const Vec3& point, double step) {
  Vec3 result;
  for (int k = 0; k < 3; ++k) {
    const Vec3 offset = step * Vec3::Unit(k);
    result[k] = (field(point + offset) - field(point - offset)) / (2 * step);
  }
  return result;
}

}  // namespace

double fieldValue(const Body& body, const Vec3& point) {
  double value = std::numeric_limits<double>::max();
  for (const Limb& limb : body.limbs) {
    if (distanceBound(limb, point) >= value + limb.blend) continue;  // cannot change the minimum
    value = smoothMin(value, nearestOnLimb(limb, point).distance, limb.blend);
  }
  return body.floor ? -smoothMin(-value, point.y() - *body.floor, floorRounding) : value;
}

BodyPoint nearestOnBody(const Body& body, const Vec3& point) {
  BodyPoint best;
  best.on.distance = std::numeric_limits<double>::max();
  for (int i = 0; i < static_cast<int>(body.limbs.size()); ++i) {
    const LimbPoint on = nearestOnLimb(body.limbs[i], point);
    if (on.distance < best.on.distance) best = {i, on};
  }
  return best;
}

double wantedEdge(const Body& body, const Vec3& point) {
  double edge = std::numeric_limits<double>::max();
  for (const Limb& limb : body.limbs) {
    if (limb.edge + 0.5 * distanceBound(limb, point) >= edge) continue;
    edge = std::min(edge, limb.edge + 0.5 * std::max(nearestOnLimb(limb, point).distance, 0.0));
  }
  return edge;
}

Vec3 projectToSurface(const Field& field, Vec3 point, double step) {
  for (int i = 0; i < 3; ++i) {
    const double value = field(point);
    const Vec3 g = gradient(field, point, step);
    point -= std::clamp(value, -10 * step, 10 * step) * g / std::max(g.squaredNorm(), 0.1);
  }
  return point;
}

}  // namespace shapespline
