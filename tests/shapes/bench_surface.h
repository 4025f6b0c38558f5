// Generates and bends the meshes.
#pragma once

#include <functional>
#include <vector>

#include "shapes/random.h"
#include "shapes/surface.h"

namespace shapespline {

/// The capsule's half spheres, and the length of the tube between them, which lies along z about the origin.
constexpr double capsuleRadius = 1, capsuleTube = 6;

/// A closed capsule with bumps of up to a sixth of its radius and irregular triangles. faces: even, at least 64;
/// exactly this number.
Surface bumpyCapsule(int faces, Random& random);

/// A unit sphere about the origin with irregular triangles, at most this number; at least 48.
Surface gridSphere(int faces, Random& random);

/// For face f and corner c the half-edge 3 f + c runs from that corner to the next. Gives the opposite half-edges, -1
/// at a boundary.
std::vector<int> oppositeHalfEdges(const std::vector<Triangle>& faces);

/// Splits random inner edges, each with two faces that have not been split yet, until one more would make more than
/// `faces`. fraction: where along the edge, in (0, 1).
void splitEdges(Surface& surface, int faces, Random& random, const std::function<double()>& fraction);

/// Random orders of vertices, faces and first corners. Returns each vertex's new index.
std::vector<int> shuffle(Surface& surface, Random& random);

struct Deformation {
  double bend = 0, twist = 0, direction = 0;  ///< radians over the whole length; direction of the bend about the axis
};

/// Bent by 60 to 120 degrees, twisted by up to 180.
Deformation randomDeformation(Random& random);

/// The z axis becomes an arc of the same length; cross-sections stay flat, are twisted about it and turned with it.
Vec3 deformed(const Deformation& deformation, const Vec3& p);

}  // namespace shapespline
