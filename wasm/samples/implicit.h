// The surface of a body: the zero set of a smooth union of its limbs.
#pragma once

#include <functional>

#include "samples/limb.h"

namespace shapespline {

/// A function of space that is negative inside a shape.
using Field = std::function<double(const Vec3&)>;

/// Negative inside; near the surface about the distance to it.
double fieldValue(const Body& body, const Vec3& point);

/// The limb whose surface is nearest, and the place on it.
struct BodyPoint {
  int limb = 0;
  LimbPoint on;
};
BodyPoint nearestOnBody(const Body& body, const Vec3& point);

/// Wanted edge length at a point: the smallest wish among the limbs, each growing by half the distance from the limb.
double wantedEdge(const Body& body, const Vec3& point);

/// Two Newton steps along the gradient towards the surface; `step` is the length for differences.
Vec3 projectToSurface(const Field& field, Vec3 point, double step);

}  // namespace shapespline
