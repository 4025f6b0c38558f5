// Generates and bends meshes.
#pragma once

#include <functional>
#include <vector>

#include "shapes/random.h"
#include "shapes/surface.h"

namespace shapespline {

/// Radius of the capsule's half spheres, and length of the tube between them, along z and centred at the origin.
constexpr double capsuleRadius = 1, capsuleTube = 6;

/// A closed capsule with bumps of up to a sixth of its radius and irregular triangles. faces: even, at least 64; the
/// exact number of faces.
Surface bumpyCapsule(int faces, Random& random);

/// A unit sphere around the origin with irregular triangles, at most `faces`; at least 48.
Surface gridSphere(int faces, Random& random);

/// Half-edge 3 f + c runs from corner c of face f to the next corner. Returns the opposite half-edges, -1 at a
/// boundary.
std::vector<int> oppositeHalfEdges(const std::vector<Triangle>& faces);

/// Splits random inner edges of two unsplit faces until another split would exceed `faces`. fraction: position along
/// the edge, in (0, 1).
void splitEdges(Surface& surface, int faces, Random& random, const std::function<double()>& fraction);

/// Random orders of vertices, faces and first corners. Returns each vertex's new index.
std::vector<int> shuffle(Surface& surface, Random& random);

struct Deformation {
  /// bend and twist in radians over the whole length; direction of the bend about the axis
  double bend = 0, twist = 0, direction = 0;
};

/// Bent by 60 to 120 degrees, twisted by up to 180.
Deformation randomDeformation(Random& random);

/// The z axis becomes an arc of equal length. Cross-sections stay flat, are twisted about the axis and rotate with it.
Vec3 deformed(const Deformation& deformation, const Vec3& p);

}  // namespace shapespline
